#pragma once
/// The render thread.

#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "render/film/smoothed_view.h"
#include "render/session/film_on_device.h"
#include "render/session/render_commands.h"
#include "render/session/session.h"

namespace pdr {

class Session::Loop {
  public:
    Loop(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback, SessionClock clock);
    ~Loop();

    RenderCommands commands;

  private:
    /// Of a coarse frame: fewer, calmer pixels are easier to follow.
    static constexpr std::uint32_t kCoarseSamples = 4;

    void run(std::stop_token stop);
    void take(const RenderCommands::Iteration& step);
    RenderCommands::LoopState state() const;

    // What a step may ask for. Each leaves either a film that can go on, or none and a frame that says why.
    void clear();
    void answer(const RenderCommands::Iteration& step) const;
    void switchTo(const DeviceOpener& open);
    void begin(const RenderCommands::SceneOrder& order);
    void work(const RenderCommands::Iteration& step);

    // Parts of work(). Errors: the device's.
    Result<void> accumulate(const RenderCommands::Iteration& step);
    Result<void> show(const RenderCommands::Iteration& step);
    Result<std::vector<Picture>> takeAllBut(int left);
    Result<void> measureDisplay(const Display& display, std::uint32_t n, double frameSeconds);
    Display wantedDisplay();
    Result<void> judgeSmoothing(const RenderCommands::Iteration& step);
    Result<void> keepCheckpoint();
    Result<void> takeSnapshots();
    void send(std::vector<Picture> pictures, std::uint32_t n);

    // Beginnings.
    void beginFilm(bool coarse);
    void startOver();
    void goOnFrom(std::shared_ptr<const Film> film);
    int divider() const;
    Scene coarseScene() const;

    // When a device fails or refuses.
    void recover(const std::string& reason);
    void failedOnDevice(const Error& error);
    void threw() noexcept;
    void fail(const std::string& sentence);
    void notify(const std::string& sentences);

    std::uint32_t wanted(const FrameBudget& pace) const;
    std::uint32_t launch(std::uint32_t wanted) const;

    double secondsSince(double moment) const { return clock_() - moment; }

    FrameSink sink_;
    DeviceOpener fallback_;
    SessionClock clock_;
    FilmOnDevice place_;
    bool onFallback_ = false;
    Scene scene_;                 ///< as it was submitted
    std::uint64_t revision_ = 0;  ///< of the scene submitted last, whatever became of it
    bool moving_ = false;
    bool coarse_ = false;  ///< the film shows the scene in fewer pixels than it asks for

    // Of the film:
    std::uint64_t samples_ = 0;  ///< that it holds
    std::uint32_t done_ = 0;     ///< iterations since it was last shown
    int waiting_ = 0;            ///< pictures ordered and not taken
    bool first_ = false;         ///< its first picture is still to come
    bool fresh_ = false;         ///< the first one from this device is
    double frameSeconds_ = 0;    ///< of the frame in the making
    double seconds_ = 0;         ///< of all of them
    SmoothedView smoothedView_;
    float exposure_ = 1;  ///< that it was last shown with

    FrameTimer meter_;
    bool measuring_ = false;  ///< the frame in the making, with nothing behind it
    double measuredAt_ = 0;   ///< when one was last

    std::shared_ptr<const Film> checkpoint_;  ///< what is left when the device is lost; null: nothing
    double checkpointAt_ = 0;
    double checkpointSeconds_ = 0;  ///< what the last one cost

    double pixelsPerSecond_ = 5e6;  ///< a guess until the first frame was timed

    std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace pdr
