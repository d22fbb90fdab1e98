#include "render/session/loop.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "render/kernel/random.h"

namespace pdr {

namespace {

constexpr double kMovingSecondsPerFrame = 1.0 / 15;  ///< what a frame may take while the hand moves
constexpr int kCoarsest = 8;                         ///< at most this many pixels of the film to one that is rendered

std::string capital(std::string text) {
    if (!text.empty())
        text.front() = char(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

/// With a full stop at its end.
std::string ended(std::string text) {
    if (!text.empty() && text.back() != '.')
        text += '.';
    return text;
}

}  // namespace

Session::Loop::Loop(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback, SessionClock clock)
    : sink_(std::move(sink)), fallback_(std::move(fallback)), clock_(std::move(clock)), place_(std::move(device)) {
    thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

Session::Loop::~Loop() {
    thread_.request_stop();
    orders.cancel();
}

void Session::Loop::run(std::stop_token stop) {
    while (const std::optional<Orders::Step> step = orders.next(situation(), stop)) {
        if (step->device)
            switchTo(step->device);
        if (step->schedule)
            restart(*step->schedule);
        if (step->order)
            begin(*step->order);
        if (place_.film() != nullptr)
            work(*step);
    }
}

Orders::Situation Session::Loop::situation() const {
    const bool film = place_.film() != nullptr;
    return {.film = film,
            .first = film && first_,
            .unshown = film && samples_ > 0 && (done_ > 0 || waiting_ > 0 || fresh_),
            .lookable = film && !moving_ && samples_ > 0};
}

/// Takes a new scene, coarser while the hand moves so that frames come soon.
void Session::Loop::begin(const Orders::SceneOrder& order) {
    moving_ = order.moving;
    Scene scene = moving_ ? coarse(order.scene) : order.scene;
    if (const Result<void> fits = scene.check(); !fits) {
        place_.forget();
        return fail(order.scene.revision, fits.error().text());
    }
    scene_ = std::move(scene);
    startOver();
    if (const Result<void> begun = place_.begin(scene_, schedule_); !begun)
        refused(begun.error());
}

void Session::Loop::restart(const Schedule& schedule) {
    schedule_ = schedule;
    if (!place_.hasScene())
        return;
    startOver();
    if (const Result<void> begun = place_.restart(schedule_); !begun)
        refused(begun.error());
}

Scene Session::Loop::coarse(Scene scene) const {
    const double pixels = double(scene.film.x) * scene.film.y;
    const double affordable = std::max(pixelsPerSecond_ * kMovingSecondsPerFrame / kMovingSamples, 1.0);
    const int divider = std::clamp(int(std::ceil(std::sqrt(pixels / affordable))), 1, kCoarsest);
    scene.film = glm::max((scene.film + divider - 1) / divider, ivec2(1));
    scene.seed ^= mixBits(scene.revision);  // else the grain would stand still on a picture that moves
    return scene;
}

void Session::Loop::switchTo(const DeviceOpener& open) {
    const std::string old = spoken(place_.info());
    std::shared_ptr<const Film> from = checkpoint_;
    std::optional<Error> lost;  // when the old device does not hand out its film
    if (place_.film() != nullptr && samples_ > 0) {
        if (const auto film = place_.film()->film())
            from = *film;
        else
            lost = film.error();
    }
    Result<std::unique_ptr<Device>> device = open();
    const Result<void> moved = device ? place_.moveTo(*std::move(device), from.get()) : device.error();
    if (moved) {
        onFallback_ = false;
        return goOnFrom(std::move(from));
    }
    if (lost)
        return stopped(*lost);
    notify("The other device cannot be used: " + ended(moved.error().text()) + " The picture goes on on " + old + ".");
}

/// Of another scene, or the same from its beginning.
void Session::Loop::startOver() {
    goOnFrom(nullptr);
    seconds_ = 0;
}

/// The film in hand is a new one, which holds what `film` holds.
void Session::Loop::goOnFrom(std::shared_ptr<const Film> film) {
    samples_ = film ? film->samplesPerPixel() : 0;
    first_ = first_ || samples_ == 0;
    done_ = 0;
    waiting_ = 0;
    fresh_ = true;
    frameSeconds_ = 0;
    meter_.clear();
    checkpoint_ = std::move(film);
    checkpointAt_ = clock_();
    checkpointSeconds_ = 0;
}

void Session::Loop::recover(const std::string& reason) {
    const std::string what = ended(capital(reason));
    if (onFallback_ || !fallback_)
        return fail(place_.revision(), what);
    Result<std::unique_ptr<Device>> device = fallback_();
    const Result<void> moved = device ? place_.moveTo(*std::move(device), checkpoint_.get()) : device.error();
    if (!moved)
        return fail(place_.revision(), what + " Nor can the picture go on elsewhere: " + moved.error().text());
    onFallback_ = true;
    goOnFrom(std::exchange(checkpoint_, nullptr));
    notify(what + " The picture goes on on " + spoken(place_.info()) + ".");
}

void Session::Loop::fail(std::uint64_t revision, const std::string& sentence) {
    place_.dropFilm();
    auto frame = std::make_shared<Frame>();
    frame->revision = revision;
    frame->error = sentence;
    sink_(std::move(frame));
}

void Session::Loop::notify(const std::string& sentences) {
    auto frame = std::make_shared<Frame>();
    frame->revision = scene_.revision;
    frame->notice = sentences;
    sink_(std::move(frame));
}

}  // namespace pdr
