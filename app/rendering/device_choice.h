#pragma once
/// Opens the devices that render: the chosen one, shared with render nodes if there are any, and another of its kind
/// for images that go into files.

#include <QObject>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "render/device/device_list.h"
#include "render/session/session.h"
#include "render/tiles/shared_device.h"

namespace pdr::app {

class DeviceChoice : public QObject {
    Q_OBJECT

  public:
    /// `threads`: number of CPU threads; 0: one per core. `preparing` is called as openDevice() does.
    explicit DeviceChoice(int threads, PreparationObserver preparing = {})
        : threads_(threads), preparing_(std::move(preparing)) {}

    /// Sets the workers that share the work of devices opened from now on; null: none. Returns false if these are set
    /// already.
    bool setPool(const std::shared_ptr<SharedWork>& pool);

    /// Opens the device `name`, shared with the workers. May be called on any thread.
    Result<std::unique_ptr<Device>> open(const std::string& name);
    /// Opens the CPU, shared with the workers. May be called on any thread.
    Result<std::unique_ptr<Device>> openCpu() { return shared(makeCpuDevice(threads_)); }
    /// Returns an opener of the CPU that is not shared.
    DeviceOpener cpuAlone() const;
    /// Returns an opener of a device for an image that goes into a file: the device `name`, or the CPU if that cannot
    /// be opened or fails later; `told` then gets the reason, on the thread that renders. Workers that produce the same
    /// bits sample that image first. May be called on any thread, as may the opener.
    DeviceOpener forFinalRender(std::string name, WhySpare told) const;

    /// Returns a function that tells what was checked of the samples of the workers. May be called on any thread, as
    /// may the function.
    std::function<NodeChecks()> nodeChecks() const;

  signals:
    /// Emitted on this object's thread when a device that shares its work has been opened. `bits`: its
    /// referenceTiles(), which workers must reproduce.
    void sharedWith(const std::vector<std::byte>& bits);

  private:
    Result<std::unique_ptr<Device>> shared(std::unique_ptr<Device> device);

    const int threads_;
    const PreparationObserver preparing_;
    mutable std::mutex mutex_;
    std::shared_ptr<SharedWork> pool_;  ///< guarded by mutex_: workers that share the work; null if none do
    std::vector<std::byte> bits_;       ///< guarded by mutex_: reference tiles of the shared device
};

}  // namespace pdr::app
