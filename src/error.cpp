#include <mirrorball/error.h>

namespace mirrorball {

Error::Error(ErrorKind kind, const std::string& asked, const std::string& found, const std::string& advice)
    : std::runtime_error(asked + ": " + found + (advice.empty() ? "" : "; " + advice)), kind_(kind)
{
}

} // namespace mirrorball
