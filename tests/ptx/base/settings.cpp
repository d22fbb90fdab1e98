#include "tests/ptx/base/settings.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace pdr::ptx {

namespace {

std::string variable(const char* name) {
    return std::string("PDR_PTX_") + name;
}

std::string valueOf(const char* name) {
    const char* value = std::getenv(variable(name).c_str());
    return value != nullptr ? value : "";
}

[[noreturn]] void refuse(const char* name) {
    std::fprintf(stderr, "ptx: %s=%s is not known\n", variable(name).c_str(), valueOf(name).c_str());
    std::exit(2);
}

template <class T>
void readNumber(const char* name, T& number) {
    const std::string value = valueOf(name);
    if (value.empty())
        return;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || end != value.data() + value.size())
        refuse(name);
}

void readSwitch(const char* name, bool& on) {
    int number = on ? 1 : 0;
    readNumber(name, number);
    if (number != 0 && number != 1)
        refuse(name);
    on = number == 1;
}

template <class T>
void readChoice(const char* name, std::initializer_list<std::pair<std::string_view, T>> choices, T& chosen) {
    const std::string value = valueOf(name);
    if (value.empty())
        return;
    for (const auto& [word, choice] : choices)
        if (value == word) {
            chosen = choice;
            return;
        }
    refuse(name);
}

}  // namespace

Settings settingsFromEnvironment() {
    Settings s;
    readChoice<Streams>(
        "STREAMS", {{"atOnce", Streams::atOnce}, {"late", Streams::late}, {"atRandom", Streams::atRandom}}, s.streams);
    readChoice<Warps>("WARPS", {{"inTurn", Warps::inTurn}, {"inOrder", Warps::inOrder}, {"atRandom", Warps::atRandom}},
                      s.warps);
    readChoice<Fill>("FILL", {{"atRandom", Fill::atRandom}, {"ones", Fill::ones}, {"zeros", Fill::zeros}}, s.fill);
    readSwitch("BY_ADDRESS", s.byAddress);
    readSwitch("RACES", s.races);
    readSwitch("UNSET", s.unset);
    readNumber("TOGETHER", s.together);
    if (s.together == 0)
        refuse("TOGETHER");
    readSwitch("TRACE", s.trace);
    readNumber("SEED", s.seed);
    s.counts = valueOf("COUNTS");
    s.fail = valueOf("FAIL");
    u64 megabytes = s.memoryBytes >> 20;
    readNumber("MEMORY_MB", megabytes);
    s.memoryBytes = megabytes << 20;
    readNumber("PROCESSORS", s.processors);
    readNumber("DEVICES", s.devices);
    readNumber("DRIVER", s.driver);
    readNumber("CAPABILITY", s.capability);
    readNumber("LARGEST_TEXTURE", s.largestTexture);
    return s;
}

}  // namespace pdr::ptx
