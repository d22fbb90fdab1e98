#include "render/session/loop.h"

#include <utility>

#include "render/base/background_thread.h"
#include "render/base/thrown.h"
#include "render/film/error/noisy_film.h"
#include "render/kernel/random.h"
#include "render/scene/not_shown.h"
#include "render/scene/scene.h"
#include "render/session/known_bias.h"

namespace pdr {

namespace {

Text goesOnOn(const Text& device) {
    return phrase("Rendering continues on %1.", device);
}

Text beginsAnewOn(const Text& device) {
    return phrase("The image begins anew on %1, which filters the volume in another way.", device);
}

}  // namespace

Session::Loop::Loop(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback, SessionClock clock)
    : sink_(std::move(sink)), fallback_(std::move(fallback)), clock_(std::move(clock)), place_(std::move(device)) {
    thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

Session::Loop::~Loop() {
    thread_.request_stop();
    commands.cancel();
}

void Session::Loop::run(std::stop_token stop) {
    workInBackground();
    while (const std::optional<RenderCommands::Iteration> step = commands.next(state(), stop)) {
        try {
            take(*step);
        } catch (...) {
            threw();
        }
    }
}

void Session::Loop::take(const RenderCommands::Iteration& step) {
    if (step.clear)
        clear();
    if (step.keptMemory)
        kept_.limit(*step.keptMemory);
    answer(step);
    quality_.chooseRegion(commands.region());
    if (step.device)
        switchTo(step.device);
    bool isBack = false;  // the next step says what is still to do on a film that came back
    if (step.order) {
        const double start = clock_();
        revision_ = step.order->scene.revision;
        isBack = begin(*step.order, step.stop);
        times_ = {.taken = start, .begun = clock_()};
    }
    if (step.watch)
        effectCosts_.watch(*step.watch);
    if (!isBack && place_.film() != nullptr && !step.idle)
        work(step);
    measureEffects(step);
}

RenderCommands::LoopState Session::Loop::state() {
    const bool film = place_.film() != nullptr;
    return {
        .scene = place_.hasScene(),
        .film = film,
        .revision = place_.hasScene() ? place_.revision() : 0,
        .owed = film && (display_.awaitsFirst() || coarse() || isHalfMade()),
        .lingers = film && (brightens_ || (moving_ && coarse() && !display_.awaitsFirst())),
        .passing = film && moving_ && display_.awaitsFirst(),
        .progress = film ? progress() : ImageProgress(),
        .unshown = film && hasSamples() && (scheduler_.hasIterations() || display_.hasWaiting() || display_.isFresh()),
        .unjudged = canSnapshot() && canJudge() && quality_.denoised().isStale(partSamples()),
        .canSnapshot = canSnapshot(),
        .unmeasured = canSnapshot() && effectCosts_.hasWork()};
}

void Session::Loop::clear() {
    goOnFrom(nullptr);
    display_.dropCoarser();
    edits_.forget();
    effectCosts_.forget();
    kept_.clear();
    dropNoisyFilms();
    scene_ = {};
    notShown_ = {};
    place_.close();
}

/// Answers the snapshot requests for a film that does not exist with the reason.
void Session::Loop::answer(const RenderCommands::Iteration& step) const {
    const Error reason =
        step.clear ? Error{phrase("the image was closed"), "", phrase("Open the series again.")}
        : step.order || place_.film() != nullptr
            ? Error{phrase("another image has taken its place"), "", phrase("Wait until the new image is there.")}
            : Error{phrase("the image could not be rendered"), "", phrase("Change the view or the look first.")};
    for (const RenderCommands::SnapshotRequest& order : step.unanswerable)
        order.look(reason);
}

/// Takes a new scene. If the drag has ended without a change, the scene is the current one and its film continues.
/// Returns whether a film that was put away has come back.
bool Session::Loop::begin(const RenderCommands::SceneOrder& order, const std::stop_token& stop) {
    moving_ = order.moving;
    if (place_.film() != nullptr && order.scene.revision == scene_.revision)
        return !moving_ && coarse() && comeBack(stop);
    keepFilm();
    if (const Result<void> fits = order.scene.check(); !fits) {
        place_.forget();
        fail(fits.error().text());
        return false;
    }
    edits_.follow(scene_, order.scene);
    scene_ = order.scene;
    notShown_ = pdr::notShown(scene_);
    effectCosts_.follow(scene_, commands.display());
    display_.dropCoarser();
    if (!moving_ && comeBack(stop))
        return true;
    if (edits_.hasOld() && smooths(commands.display()))
        scheduler_.chooseEdited(dividerForEdit(), moving_);
    else
        scheduler_.chooseFirst(scene_.film, moving_);
    if (scheduler_.isCoarseEdit())
        (void)renderBefore();  // without it, the image is made as if there were no old one; a lost device fails below
    beginFilm();
    return false;
}

/// Starts an empty film of the scene, as coarse as was chosen.
void Session::Loop::beginFilm() {
    goOnFrom(nullptr);
    quality_.startOver(coarse());
    const double start = clock_();
    if (const Result<void> begun = place_.begin(divided(scene_)); !begun)
        return failedOnDevice(begun.error());
    scheduler_.reset(TileProgress(wholeImage(place_.size())));
    scheduler_.addBeginning(clock_() - start);
}

/// Starts the next finer film of the same scene. The current image stays until the new film's image is no worse.
void Session::Loop::beginFiner(const std::stop_token& stop) {
    Result<std::shared_ptr<const Film>> film = place_.film()->film();
    if (!film)
        return failedOnDevice(film.error());
    display_.keepCoarser(*std::move(film));
    // Features are at hand where guides are
    const bool onFeatures = !edits_.hasOld() && display_.hasGuide() && EditedView::canKeep(scene_);
    scheduler_.chooseFiner(scene_.film, onFeatures);
    beginFilm();
    if (onFeatures && !coarse() && place_.film() != nullptr)
        findFeatures(stop);
}

/// Returns `scene` as it is rendered, of fewer pixels and with other random numbers if the film is coarse.
Scene Session::Loop::divided(Scene scene) const {
    if (!coarse())
        return scene;
    // Otherwise the noise pattern would stand still on a moving image. What an edit changes is seen with one pattern.
    const std::uint64_t pattern = scheduler_.isCoarseEdit() ? edits_.oldScene().revision : scene.revision;
    return dividedBy(scheduler_.divider(), std::move(scene), pattern);
}

/// Returns `scene` with fewer pixels, and the random numbers of a noise pattern.
Scene Session::Loop::dividedBy(int divider, Scene scene, std::uint64_t pattern) {
    scene.film = dividedFilm(scene.film, divider);
    scene.seed ^= mixBits(pattern);
    return scene;
}

void Session::Loop::switchTo(const DeviceOpener& open) {
    const Text old = deviceLabel(place_.info());
    std::shared_ptr<const Film> from = checkpoint_.film();
    std::optional<Error> lost;  // set if the old device does not return its film
    if (place_.film() != nullptr && hasSamples()) {
        if (const auto film = place_.film()->film())
            from = *film;
        else
            lost = film.error();
    }
    const Result<bool> dropped = moveTo(open(), std::move(from));
    if (dropped) {
        onFallback_ = false;
        return *dropped ? notify(beginsAnewOn(deviceLabel(place_.info()))) : void();
    }
    if (lost)
        return failedOnDevice(*lost);
    notify(
        joined(Text::sentence(phrase("the other device cannot be used: %1", dropped.error().text())), goesOnOn(old)));
}

/// Moves the image to `device`, with the samples of `from`, null for none, if those are what `device` takes: texture
/// units read the volume in another way. Returns whether samples were dropped. Errors: the device's; nothing changes
/// then.
Result<bool> Session::Loop::moveTo(Result<std::unique_ptr<Device>> device, std::shared_ptr<const Film> from) {
    if (!device)
        return device.error();
    const auto hasTextures = [&](const DeviceInfo& info) { return texturesFilter(scene_, info.name); };
    const bool isAnew = from && hasTextures(place_.info()) != hasTextures((*device)->info());
    if (isAnew)
        from = nullptr;
    if (const Result<void> moved = place_.moveTo(*std::move(device), from.get()); !moved)
        return moved.error();
    goOnFrom(std::move(from));
    return isAnew;
}

/// Resets the state for a new film, which already holds the samples of `film`; null: none.
void Session::Loop::goOnFrom(std::shared_ptr<const Film> film) {
    scheduler_.reset(film                ? film->progress()
                     : place_.hasScene() ? TileProgress(wholeImage(place_.size()))
                                         : TileProgress());
    display_.reset(!hasSamples());
    features_.startOver();
    if (!film)
        edits_.startOver();
    quality_.clear();
    bias_.clear();
    shown_ = returning_ = nullptr;
    checkpoint_.reset(std::move(film));
}

void Session::Loop::failedOnDevice(const Error& error) {
    const bool lost = error.kind == ErrorKind::deviceLost;
    recover(phrase(lost ? "%1 stopped answering: %2" : "%1 cannot render this image: %2", deviceLabel(place_.info()),
                   error.text()));
}

void Session::Loop::recover(const Text& reason) {
    const Text what = Text::sentence(reason);
    if (onFallback_ || !fallback_)
        return fail(what);
    const Result<bool> dropped = moveTo(fallback_(), checkpoint_.film());
    if (!dropped)
        return fail(joined(what, phrase("Rendering cannot continue elsewhere: %1", dropped.error().text())));
    onFallback_ = true;
    const Text label = deviceLabel(place_.info());
    notify(joined(what, *dropped ? beginsAnewOn(label) : goesOnOn(label)));
}

/// Handles an exception, inside a catch block, like any other fault. Frees the film's memory first: even if that is too
/// little to continue on another device, it may be enough to report the error.
void Session::Loop::threw() noexcept {
    for (const bool elsewhere : {!place_.info().hostMemory, false}) {
        try {
            place_.dropFilm();
            kept_.clear();
            const Text sentence = phrase("This image cannot be rendered: %1", thrownError().text());
            return elsewhere ? recover(sentence) : fail(sentence);
        } catch (...) {
            continue;
        }
    }
}

void Session::Loop::fail(const Text& sentence) {
    place_.dropFilm();
    display_.dropCoarser();
    auto frame = std::make_shared<Frame>();
    frame->revision = revision_;
    frame->error = sentence;
    sink_(std::move(frame));
}

void Session::Loop::notify(const Text& sentences) {
    auto frame = std::make_shared<Frame>();
    frame->revision = revision_;
    frame->notice = sentences;
    frame->device = place_.info().name;
    sink_(std::move(frame));
}

}  // namespace pdr
