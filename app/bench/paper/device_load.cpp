#include "app/bench/paper/device_load.h"

#include <dlfcn.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <mutex>
#include <thread>

#include "render/base/processor_time.h"

namespace pdr::bench {

namespace {

using Clock = std::chrono::steady_clock;

class ProcessorLoad final : public DeviceLoad {
  public:
    explicit ProcessorLoad(int threads) : threads_(threadCount(threads)) {}

    std::string source() const override {
        return "processor time of " + std::to_string(threads_) + (threads_ == 1 ? " thread" : " threads");
    }
    void start() override {
        began_ = Clock::now();
        spent_ = processorSeconds();
    }
    std::optional<double> stop() override {
        const double wall = std::chrono::duration<double>(Clock::now() - began_).count();
        if (!(wall > 0))
            return std::nullopt;
        return std::clamp((processorSeconds() - spent_) / (wall * threads_), 0.0, 1.0);
    }

  private:
    int threads_;
    Clock::time_point began_ = Clock::now();
    double spent_ = 0;
};

/// Functions of NVIDIA's management library, found at run time, because the program must also start without a driver.
/// Names and layouts: nvml.h.
class Nvml {
  public:
    explicit Nvml(unsigned number) : library_(dlopen("libnvidia-ml.so.1", RTLD_NOW | RTLD_LOCAL)) {
        if (library_ == nullptr)
            return;
        const auto init = find<int (*)()>("nvmlInit_v2");
        const auto handle = find<int (*)(unsigned, void**)>("nvmlDeviceGetHandleByIndex_v2");
        rates_ = find<int (*)(void*, Rates*)>("nvmlDeviceGetUtilizationRates");
        shutdown_ = find<int (*)()>("nvmlShutdown");
        if (!init || !handle || !rates_ || !shutdown_ || init() != kSuccess)
            return;
        started_ = true;
        if (handle(number, &device_) != kSuccess)
            device_ = nullptr;
    }
    ~Nvml() {
        if (started_)
            shutdown_();
        if (library_ != nullptr)
            dlclose(library_);
    }
    Nvml(const Nvml&) = delete;
    Nvml& operator=(const Nvml&) = delete;

    /// Returns the load over the last sixth of a second to a second, [0, 1].
    std::optional<double> load() const {
        Rates rates{};
        if (device_ == nullptr || rates_(device_, &rates) != kSuccess)
            return std::nullopt;
        return 0.01 * rates.gpu;
    }

  private:
    static constexpr int kSuccess = 0;
    struct Rates {
        unsigned gpu, memory;  ///< percent
    };

    template <class Function>
    Function find(const char* name) const {
        return reinterpret_cast<Function>(dlsym(library_, name));
    }

    void* library_;
    void* device_ = nullptr;
    int (*rates_)(void*, Rates*) = nullptr;
    int (*shutdown_)() = nullptr;
    bool started_ = false;
};

class GpuLoad final : public DeviceLoad {
  public:
    explicit GpuLoad(unsigned number) : nvml_(number), sampler_([this](std::stop_token ended) { sample(ended); }) {}

    std::string source() const override { return "the driver (NVML)"; }
    void start() override {
        const std::scoped_lock lock(mutex_);
        began_ = Clock::now();
        sum_ = 0;
        count_ = 0;
    }
    std::optional<double> stop() override {
        const std::scoped_lock lock(mutex_);
        began_.reset();
        if (count_ == 0)
            return std::nullopt;
        return sum_ / count_;
    }

  private:
    static constexpr std::chrono::milliseconds kBetween{20};
    /// Time after start() that is not counted. The driver's figure is about the time before it, so at first it is about
    /// what ran before.
    static constexpr std::chrono::milliseconds kSettling{250};

    void sample(std::stop_token ended) {
        for (; !ended.stop_requested(); std::this_thread::sleep_for(kBetween)) {
            const std::scoped_lock lock(mutex_);
            if (!began_ || Clock::now() - *began_ < kSettling)
                continue;
            if (const std::optional<double> load = nvml_.load()) {
                sum_ += *load;
                ++count_;
            }
        }
    }

    Nvml nvml_;
    std::mutex mutex_;
    std::optional<Clock::time_point> began_;  ///< null: no measurement is in progress
    double sum_ = 0;
    int count_ = 0;
    std::jthread sampler_;  ///< last, because it uses the other members
};

}  // namespace

int threadCount(int threads) {
    return threads > 0 ? threads : int(std::max(1u, std::thread::hardware_concurrency()));
}

std::unique_ptr<DeviceLoad> processorLoad(int threads) {
    return std::make_unique<ProcessorLoad>(threads);
}

std::unique_ptr<DeviceLoad> gpuLoad(unsigned number) {
    return std::make_unique<GpuLoad>(number);
}

std::unique_ptr<DeviceLoad> loadOf(const std::string& name, int threads) {
    if (!name.starts_with("cuda"))
        return processorLoad(threads);
    unsigned number = 0;
    if (const std::size_t colon = name.find(':'); colon != std::string::npos)
        std::from_chars(name.data() + colon + 1, name.data() + name.size(), number);
    return gpuLoad(number);
}

}  // namespace pdr::bench
