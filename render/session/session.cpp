#include "render/session/session.h"

#include <chrono>
#include <utility>

#include "render/scene/scene.h"
#include "render/session/loop.h"

namespace pdr {

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Session::Session(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback, SessionClock clock)
    : loop_(std::make_unique<Loop>(std::move(device), std::move(sink), std::move(fallback), std::move(clock))) {}

Session::~Session() = default;

void Session::submit(Scene scene, bool moving) {
    loop_->commands.submit(std::move(scene), moving);
}

void Session::setDisplay(const Display& display) {
    loop_->commands.setDisplay(display);
}

void Session::setErrorMap(bool wanted) {
    loop_->commands.setErrorMap(wanted);
}

void Session::setRegion(const std::optional<Region>& region) {
    loop_->commands.setRegion(region);
}

void Session::setPace(const FrameBudget& pace) {
    loop_->commands.setPace(pace);
}

void Session::setKeptMemory(std::size_t bytes) {
    loop_->commands.setKeptMemory(bytes);
}

void Session::setIterationsPerFrame(int n) {
    loop_->commands.setPace({.iterations = n});
}

void Session::setDevice(DeviceOpener open) {
    loop_->commands.setDevice(std::move(open));
}

void Session::setPaused(bool paused) {
    loop_->commands.setPaused(paused);
}

void Session::setYielding(bool yielding) {
    loop_->commands.setYielding(yielding);
}

void Session::setStop(const StopRule& rule) {
    loop_->commands.setStop(rule);
}

void Session::goOn() {
    loop_->commands.goOn();
}

void Session::clear() {
    loop_->commands.clear();
}

void Session::requestSnapshot(std::uint64_t revision, SnapshotObserver look) {
    loop_->commands.requestSnapshot(revision, std::move(look));
}

void Session::watchEffects(EffectsWatch watch) {
    loop_->commands.watchEffects(std::move(watch));
}

}  // namespace pdr
