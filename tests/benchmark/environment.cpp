#include "environment.h"

#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <thread>

namespace tests::benchmark {

namespace {

std::string revision()
{
    std::FILE* const git =
        popen("git -C '" MIRRORBALL_SOURCE_DIR "' describe --always --dirty 2>/dev/null", "r");
    if (git == nullptr)
        return "unknown";
    std::array<char, 64> text{};
    const bool hasLine = std::fgets(text.data(), text.size(), git) != nullptr;
    pclose(git);
    const std::string line = hasLine ? text.data() : "";
    return line.empty() ? "unknown" : line.substr(0, line.find('\n'));
}

} // namespace

std::string processor()
{
    std::string model = "unknown processor";
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) {
            model = line.substr(line.find(':') + 2);
            break;
        }
    return std::to_string(std::thread::hardware_concurrency()) + " x " + model;
}

std::string runName()
{
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", std::gmtime(&now));
    return std::string(text.data()) + ", revision " + revision();
}

} // namespace tests::benchmark
