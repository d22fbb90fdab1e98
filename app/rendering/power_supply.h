#pragma once
/// Finds out whether this machine runs on its battery.

#include <filesystem>

namespace pdr::app {

/// Folder in which Linux reports batteries and mains supplies.
inline constexpr auto kPowerSupplies = "/sys/class/power_supply";

/// Returns true if a battery of the machine itself is discharging and no mains or USB supply is online; false if
/// nothing can be read. `folder` is laid out as kPowerSupplies: a folder for each supply, with the files type, scope,
/// status and online.
bool onBattery(const std::filesystem::path& folder);

}  // namespace pdr::app
