#include "app/rendering/power_supply.h"

#include <fstream>
#include <string>
#include <system_error>

namespace pdr::app {
namespace {

namespace fs = std::filesystem;

/// Returns the first word of a short file; empty if it cannot be read.
std::string word(const fs::path& file) {
    std::ifstream stream(file);
    std::string text;
    stream >> text;
    return text;
}

}  // namespace

/// Skips supplies of scope Device: mice and keyboards have batteries, too.
bool onBattery(const fs::path& folder) {
    bool discharges = false;
    std::error_code problem;
    for (fs::directory_iterator supply(folder, problem), end; !problem && supply != end; supply.increment(problem)) {
        const fs::path& path = supply->path();
        if (word(path / "scope") == "Device")
            continue;
        if (word(path / "type") != "Battery" && word(path / "online") == "1")
            return false;
        discharges = discharges || (word(path / "type") == "Battery" && word(path / "status") == "Discharging");
    }
    return discharges;
}

}  // namespace pdr::app
