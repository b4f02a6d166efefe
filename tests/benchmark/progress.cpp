#include "progress.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace tests::benchmark {

namespace {

constexpr int barWidth = 30;
constexpr std::chrono::milliseconds refresh{200};

std::string minutesAndSeconds(double seconds)
{
    char text[32];
    const auto whole = static_cast<int>(seconds + 0.5);
    std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
    return text;
}

} // namespace

Progress::Progress(double steps)
    : steps_(steps), isTerminal_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()),
      shown_(start_ - refresh)
{
}

Progress::~Progress()
{
    if (isTerminal_)
        std::fputc('\n', stderr);
}

void Progress::advance(double steps)
{
    done_ = std::min(done_ + steps, steps_);
    show();
}

void Progress::show()
{
    const auto now = std::chrono::steady_clock::now();
    const double share = done_ / steps_;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const std::string left = minutesAndSeconds(elapsed * (1.0 - share) / std::max(share, 1e-6));
    if (isTerminal_ && (now - shown_ >= refresh || done_ >= steps_)) {
        shown_ = now;
        const auto filled = static_cast<std::size_t>(share * barWidth);
        const std::string bar = std::string(filled, '#') + std::string(barWidth - filled, '.');
        std::fprintf(stderr, "\r[%s] %3.0f %%  %s left  %-28.28s", bar.c_str(), 100.0 * share, left.c_str(),
                     label_.c_str());
        std::fflush(stderr);
    } else if (!isTerminal_ && static_cast<int>(share * 10.0) > shownTenth_) {
        shownTenth_ = static_cast<int>(share * 10.0);
        std::fprintf(stderr, "%3d %%, %s left, %s\n", 10 * shownTenth_, left.c_str(), label_.c_str());
    }
}

} // namespace tests::benchmark
