#include "support/hostile_state.h"

#include "support/hostile_state_entries.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace tests {

HostileState::HostileState() : objects_(std::make_unique<HostObjects>())
{
    // Pixel transfer after the fixed function, whose polygon stipple is itself unpacked.
    for (const auto& group : {hostileRasterisation(), hostileFragments(), hostileFixedFunction(),
                              hostileTransfer(), hostileBindings()})
        for (const HostileEntry& entry : group)
            if (has(entry.gate)) {
                entries_.push_back(&entry);
                names_.emplace_back(entry.name);
            }
}

HostileState::~HostileState()
{
    undo();
}

void HostileState::apply(const std::vector<std::string>& chosen)
{
    for (const std::string& name : chosen)
        if (std::find(names_.begin(), names_.end(), name) == names_.end()) {
            std::fprintf(stderr, "no hostile state of this context: %s\n", name.c_str());
            std::exit(1);
        }
    for (const HostileEntry* entry : entries_)
        if (std::find(chosen.begin(), chosen.end(), entry->name) != chosen.end()) {
            entry->apply(*objects_);
            applied_.push_back(entry);
        }
}

std::vector<std::string> HostileState::random(std::uint32_t seed) const
{
    std::mt19937 generator(seed); // its sequence is the standard's; a distribution's is not
    std::vector<std::string> chosen;
    for (const std::string& name : names_)
        if ((generator() & 0x80000000u) != 0)
            chosen.push_back(name);
    return chosen;
}

void HostileState::undo()
{
    for (; !applied_.empty(); applied_.pop_back())
        applied_.back()->undo(*objects_);
}

void HostileState::beginTransformFeedback()
{
    static constexpr HostileEntry active{"transform feedback active", always,
                                         [](const HostObjects& host) {
                                             glUseProgram(host.program);
                                             glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, host.buffer);
                                             glBeginTransformFeedback(GL_TRIANGLES);
                                         },
                                         [](const HostObjects&) {
                                             glEndTransformFeedback();
                                             glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
                                             glUseProgram(0);
                                         }};
    active.apply(*objects_);
    applied_.push_back(&active);
}

} // namespace tests
