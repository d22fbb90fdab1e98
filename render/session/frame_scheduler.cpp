/// How frames are planned from the times of recent ones.

#include "render/session/frame_scheduler.h"

#include <algorithm>

#include "render/edit/first_samples.h"

namespace pdr {

namespace {

/// Longest duration of a launch, so that a change of brightness or device, a pause or a snapshot need not wait for a
/// long frame; and of a piece of a launch, if it can be split. On a busy machine both take several times as long.
constexpr double kLaunchSeconds = 0.06, kPieceSeconds = 0.015;
/// Longest and shortest time for the samples of an image of a shared film. A pause or a snapshot waits for the longest.
/// Images that follow sooner than the shortest are hardly seen, and travel all the same.
constexpr double kSharedSeconds = 2, kLeastSharedSeconds = 0.2;
/// Growth of the samples of a shared film after which an image is worth sending: the error halves. An image has at most
/// kMostSharedGrowth times the samples of the one before, which tell how fast they are.
constexpr std::uint64_t kSharedGrowth = 4, kMostSharedGrowth = 64;
/// Most time that the samples of a coarse film may take after an edit, in parts of what is left for them.
constexpr double kMostOfEdit = 1.5;
constexpr double kMeasureSeconds = 2;  ///< between two frames whose display is timed alone

}  // namespace

void FrameScheduler::chooseFirst(ivec2 size, bool moving) {
    divider_ = ladder_.first(size);
    passing_ = moving;
    ofEdit_ = false;
}

void FrameScheduler::chooseEdited(int divider, bool moving) {
    divider_ = divider;
    moving_ = moving;
    passing_ = false;
    ofEdit_ = true;
}

void FrameScheduler::chooseFiner(ivec2 size, bool onFeatures) {
    divider_ = isCoarseEdit() ? 1
               : onFeatures   ? ladder_.nextOnFeatures(divider_, size)
                              : ResolutionLadder::next(divider_);
    passing_ = ofEdit_ = false;
}

void FrameScheduler::chooseFull() {
    divider_ = 1;
    passing_ = ofEdit_ = false;
}

void FrameScheduler::addBeginning(double seconds) {
    if (ofEdit_)
        ladder_.addEditBeginning(seconds);
    else
        ladder_.addBeginning(seconds);
}

void FrameScheduler::reset(TileProgress progress) {
    sweep_ = Sweep(std::move(progress));
    timer_.clear();
    done_ = ahead_ = {};
    isEven_ = true;
    isTimed_ = false;
}

double FrameScheduler::secondsAhead() const {
    const SampleCounts counts = samples();
    return ahead_.n > 0 ? ahead_.seconds / ahead_.n * double(counts.most - counts.least) : 0;
}

double FrameScheduler::pixels() const {
    return double(pixelCount(sweep_.area()));
}

double FrameScheduler::partPixels() const {
    return double(pixelCount(sweep_.part()));
}

void FrameScheduler::beginFrame(const Tile& part, bool overlaps, bool fresh) {
    sweep_.choose(part);
    const SampleCounts counts = samples();
    isEven_ = sweep_.isWhole() && counts.least == counts.most;
    const bool isDue = fresh || !timer_.settled() || clock_() - timedAt_ > kMeasureSeconds;
    isTimed_ = isEven_ && overlaps && !isCoarse() && isDue;
}

Sweep::Order FrameScheduler::next(const Demand& demand, bool inPieces) {
    if (!sweep_.isHalfMade())
        sweep_.begin(launch(demand));
    if (demand.isShared)
        return sweep_.next(ladder_.speed() * kLaunchSeconds / sweep_.passSamples());
    return sweep_.next(inPieces && sweep_.passSamples() == 1 ? ladder_.speed() * kPieceSeconds : pixels());
}

/// Returns how many samples the pixels that lag behind in the part have left to the next mark.
std::uint64_t FrameScheduler::leftToMark() const {
    return FirstSamples::leftToMark(sweep_.partSamples());
}

/// Returns the samples of the next image of a shared film, which may well have `usual` ones: up to a power of
/// kSharedGrowth; where the image would be late, those that are in time, if they can to the end of a block, where no
/// sums of a part of it travel.
std::uint32_t FrameScheduler::worthSending(std::uint32_t usual) const {
    const std::uint64_t had = sweep_.partSamples(), before = had - std::min<std::uint64_t>(done_.n, had);
    const double speed = ladder_.speed() / partPixels();
    const auto within = [&](double seconds) {
        return std::max<std::uint64_t>(usual, std::uint64_t(std::clamp(speed * seconds, 1.0, 1e6)));
    };
    std::uint64_t end = 1;
    while (end < std::min(before + within(kLeastSharedSeconds), kMostSharedGrowth * before))
        end *= kSharedGrowth;
    const std::uint64_t late = before + within(kSharedSeconds);
    if (end <= late)
        return std::uint32_t(end - before);
    const std::uint64_t blocks = late - late % kSamplesPerBlock;
    return std::uint32_t((blocks > before ? blocks : late) - before);
}

/// Returns the part of a coarse frame's time that its samples may take [s].
double FrameScheduler::secondsForSamples() const {
    return isCoarseEdit() ? ladder_.secondsForEdit(moving_) : ladder_.secondsForSamples(pixels());
}

/// Returns how many iterations to request at once. The first iteration of a first image shows how many are in time.
std::uint32_t FrameScheduler::launch(const Demand& demand) const {
    if (hurries(demand) && done_.n == 0)
        return 1;
    const std::uint32_t all = wanted(demand), left = all > done_.n ? all - done_.n : 1;
    if (demand.isShared && !isCoarse())
        return left;
    if (hurries(demand) && isCoarseEdit())
        return std::uint32_t(std::min<std::uint64_t>(left, leftToMark()));
    const double seconds = hurries(demand) ? secondsForSamples() - done_.seconds : kLaunchSeconds;
    const double speed = done_.n > 0 && done_.seconds > 0 ? done_.n / done_.seconds : ladder_.speed() / partPixels();
    const auto most = double(demand.keepsFirst ? std::min<std::uint64_t>(left, leftToMark()) : left);
    return std::uint32_t(std::clamp(speed * seconds, 1.0, most));
}

void FrameScheduler::took(const Sweep::Order& order, double seconds) {
    done_.n += sweep_.took(order);
    done_.seconds += seconds;
}

std::uint32_t FrameScheduler::wanted(const Demand& demand) const {
    const double larger = pixels() / partPixels();
    const std::uint32_t usual =
        isCoarse() ? ResolutionLadder::kSamples : std::uint32_t(larger * timer_.iterations(demand.pace));
    const std::uint64_t before = samples().least - std::min<std::uint64_t>(done_.n, samples().least);
    const bool isSent = demand.isShared && demand.pace.automatic;
    const std::uint32_t paced = isSent ? worthSending(usual) : usual;
    const std::uint32_t whole = std::max(paced, std::uint32_t(demand.replaced.value_or(0)));
    const bool isLast = demand.stopsAt > before && demand.stopsAt - before < whole;
    const std::uint32_t all = isLast ? std::uint32_t(demand.stopsAt - before) : whole;
    return demand.stopsAtMarks && !isSent
               ? std::uint32_t(std::min<std::uint64_t>(all, FirstSamples::leftToMark(before)))
               : all;
}

bool FrameScheduler::isComplete(const Demand& demand) const {
    const bool isEnough = done_.n >= wanted(demand) || (hurries(demand) && isLate());
    return !sweep_.isHalfMade() && isEnough;
}

/// Returns whether more samples would come too late for a first image. After an edit only those with which the next
/// mark is reached count (edit/first_samples.h), so that it is all of them or the first alone.
bool FrameScheduler::isLate() const {
    if (!isCoarseEdit())
        return done_.seconds >= secondsForSamples();
    return done_.n > 0 && ResolutionLadder::kSamples * done_.seconds > kMostOfEdit * secondsForSamples() * done_.n;
}

FrameScheduler::Iterations FrameScheduler::endFrame() {
    return std::exchange(done_, {});
}

void FrameScheduler::addImage(const TimedImage& image) {
    const auto& [n, seconds] = image.iterations;
    const double all = seconds + image.displaySeconds;
    if (!sweep_.isWhole()) {
        ahead_.n += n;
        ahead_.seconds += all;
    }
    if (isEven_ && image.overlaps) {
        timer_.addPeriod(n, all);
        ladder_.addFrame(n * pixels(), all);
    } else if (isEven_) {
        timer_.addFrame(n, seconds, image.displaySeconds);
        ladder_.addFrame(n * pixels(), seconds);
    }
    if (image.isEdit && isCoarseEdit())
        ladder_.addCoarseEditDisplay(image.displaySeconds);
    else if (image.isEdit)
        ladder_.addEditedDisplay(pixels(), image.displaySeconds);
    else if (image.isOnGuide)
        ladder_.addGuidedDisplay(pixels(), image.displaySeconds);
    else if (!image.overlaps)
        ladder_.addDisplay(pixels(), image.displaySeconds);
}

void FrameScheduler::addTimedFrame(std::uint32_t n, double seconds, double displaySeconds) {
    timer_.addFrame(n, std::max(seconds - displaySeconds, 0.0), displaySeconds);
    isTimed_ = false;
    timedAt_ = clock_();
}

}  // namespace pdr
