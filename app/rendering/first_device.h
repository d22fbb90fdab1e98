#pragma once
/// The device with which the window begins.

#include <memory>

#include "render/device/device.h"
#include "render/device/preparation.h"

namespace pdr::app {

struct FirstDevice {
    std::unique_ptr<Device> device;
    Text notice;  ///< why it is not the device that the user wants, as a sentence; empty: it is, or there is no GPU
};

/// Opens the device `asked`, as requested on the command line; if that is empty `last`, the one chosen last, or the
/// best one where that cannot be used. `threads`: threads of the CPU; 0 = one per core. `preparing` is called as
/// openDevice() does. Errors: those of `asked`.
Result<FirstDevice> firstDevice(const std::string& asked, const std::string& last, int threads,
                                const PreparationObserver& preparing = {});

}  // namespace pdr::app
