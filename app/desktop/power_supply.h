#pragma once
/// Whether this machine runs on its battery.

#include <filesystem>

namespace pdr::app {

/// Where Linux tells of batteries and mains.
inline constexpr auto kPowerSupplies = "/sys/class/power_supply";

/// True where a battery of the machine itself discharges and no mains or USB supply is online. `folder` is laid out as
/// kPowerSupplies: a folder for each supply, with the files type, scope, status and online. False where nothing can be
/// read.
bool onBattery(const std::filesystem::path& folder);

}  // namespace pdr::app
