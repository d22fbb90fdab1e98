#include "app/bench/accuracy_cost/session_run.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "app/bench/accuracy_cost/metered_device.h"
#include "render/base/processor_time.h"
#include "render/session/session.h"

namespace pdr::bench {
namespace {

/// Costs of a session at each look, collected until the last one.
class Looks {
  public:
    Looks(const std::vector<std::uint64_t>& samples, const Meter& meter) : wanted_(samples), meter_(meter) {}

    /// Takes a frame. Called on the render thread.
    void take(const Frame& frame) {
        const Moment now{processorSeconds(), meter_.samples, meter_.parts};
        const std::lock_guard lock(mutex_);
        if (!frame.error.empty())
            error_ = frame.error;
        if (!frame.coarse && frame.error.empty() && frame.notice.empty()) {
            if (!first_)
                first_ = now;
            while (costs_.size() < wanted_.size() && frame.status.samplesPerPixel >= wanted_[costs_.size()]) {
                const double sampling = now.samples - first_->samples, all = now.processor - first_->processor;
                costs_.push_back({frame.status.samplesPerPixel, sampling, all - sampling, now.parts - first_->parts});
            }
        }
        changed_.notify_all();
    }
    Result<std::vector<RunCost>> await() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !error_.empty() || costs_.size() == wanted_.size(); });
        if (!error_.empty())
            return Error{error_, "", ""};
        return costs_;
    }

  private:
    struct Moment {
        double processor, samples, parts;
    };

    const std::vector<std::uint64_t>& wanted_;
    const Meter& meter_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Moment> first_;
    std::vector<RunCost> costs_;
    std::string error_;
};

}  // namespace

Result<std::vector<RunCost>> runSession(const RunPlan& plan, Beside beside) {
    Meter meter;
    Looks looks(plan.samples, meter);
    const Told told = beside == Beside::nothing ? Told::nothing : Told::status;
    Session session(meteredDevice(makeCpuDevice(plan.threads), told, meter),
                    [&](const std::shared_ptr<const Frame>& frame) { looks.take(*frame); });
    session.setDisplay({plan.exposure, beside >= Beside::judgement});
    session.setErrorMap(beside == Beside::errorMap);
    session.setIterationsPerFrame(plan.iterations);
    session.setStop({.levels = 1e-6});  // never reached: the session renders until the last look
    if (beside == Beside::effectCosts)
        session.watchEffects({[&] { return Result(makeCpuDevice(plan.threads)); }, [](const auto&) {}});
    Scene scene = plan.scene;
    scene.revision = 1;
    if (beside == Beside::lattice)
        scene.estimator = Estimator::kroesMarch;
    session.submit(std::move(scene), false);
    return looks.await();
}

}  // namespace pdr::bench
