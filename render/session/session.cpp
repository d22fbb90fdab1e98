#include "render/session/session.h"

#include <chrono>
#include <utility>

#include "render/session/loop.h"

namespace pdr {

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Session::Session(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback, SessionClock clock)
    : loop_(std::make_unique<Loop>(std::move(device), std::move(sink), std::move(fallback), std::move(clock))) {}

Session::~Session() = default;

void Session::submit(Scene scene, bool moving) {
    loop_->orders.submit(std::move(scene), moving);
}

void Session::setDisplay(const Display& display) {
    loop_->orders.setDisplay(display);
}

void Session::setPace(const Pace& pace) {
    loop_->orders.setPace(pace);
}

void Session::setIterationsPerFrame(int n) {
    loop_->orders.setPace({.iterations = n});
}

void Session::setSchedule(const Schedule& schedule) {
    loop_->orders.setSchedule(schedule);
}

void Session::setDevice(DeviceOpener open) {
    loop_->orders.setDevice(std::move(open));
}

void Session::setPaused(bool paused) {
    loop_->orders.setPaused(paused);
}

void Session::clear() {
    loop_->orders.clear();
}

void Session::inspect(std::uint64_t revision, FilmLook look) {
    loop_->orders.inspect(revision, std::move(look));
}

}  // namespace pdr
