// The same picture traced ray by ray, without OpenGL: what drawPicture is judged by.
#pragma once

#include "picture.h"
#include "setup.h"

namespace render {

Picture tracePicture(const Setup& setup, const Options& options);

} // namespace render
