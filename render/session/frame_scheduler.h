#pragma once
/// Chooses how coarse the film of a scene is, which part of it is sampled next, and how many iterations an image gets,
/// from the time that recent ones took.
///   coarse film   one of fewer pixels, or one begun during a drag: soon replaced by a finer one
///   part          pixels that a frame samples: the image or the cells around a region of it
///   overlap       the device works on while an image is read back, so that the two have only a common time

#include <cstdint>
#include <optional>
#include <utility>

#include "render/session/resolution_ladder.h"
#include "render/session/session.h"
#include "render/session/sweep.h"
#include "render/timing/frame_budget.h"

namespace pdr {

class FrameScheduler {
  public:
    /// What the next image has to satisfy.
    struct Demand {
        FrameBudget pace;
        /// Samples per pixel of the coarser image on the screen that it replaces; none: there is no such image, so that
        /// a coarse film's image must come in time.
        std::optional<std::uint64_t> replaced;
        /// No launch goes past a mark, so that the image after the first samples can be kept (edit/first_samples.h).
        bool keepsFirst = false;
        /// The first images are made with that before an edit, or on features of the scene: one after each mark, which
        /// with one sample is better than a coarse one of more.
        bool stopsAtMarks = false;
        /// Other machines have a part of the samples. The sums of a pixel travel for each image, so that images come
        /// less often: when the samples have grown fourfold, or after two seconds.
        bool isShared = false;
        /// Samples of every pixel with which rendering stops: no image has more; 0: no limit.
        std::uint64_t stopsAt = 0;
    };
    /// Iterations of the sampled part, and the time they took [s].
    struct Iterations {
        std::uint32_t n = 0;
        double seconds = 0;
    };
    /// An image that shows new iterations.
    struct TimedImage {
        Iterations iterations;
        double displaySeconds = 0;
        bool overlaps = false;
        bool isOnGuide = false;  ///< it is a coarse film's, drawn on a guide
        bool isEdit = false;     ///< it is made with the image before an edit
    };

    explicit FrameScheduler(SessionClock clock) : clock_(std::move(clock)) {}

    // Films. Choices of how coarse the next one is:
    /// Chooses the first film of a scene whose full film has `size` pixels. `moving`: the user drags.
    void chooseFirst(ivec2 size, bool moving);
    /// Returns the divider of the first film after an edit whose image is made with the one before: 1, the full film,
    /// if one sample of each pixel comes in time, else that of a coarse film for the change alone.
    int dividerForEdit(ivec2 size, bool moving) const {
        return ladder_.editIsInTime(size) ? 1 : ladder_.forEdit(size, moving);
    }
    /// Chooses the film of that divider after such an edit.
    void chooseEdited(int divider, bool moving);
    /// Chooses the next finer film of the same scene, whose full film has `size` pixels; after the coarse film of an
    /// edit the full one, whose image is as good from the first sample. `onFeatures`: images of the full film are made
    /// on features of the scene.
    void chooseFiner(ivec2 size, bool onFeatures);
    /// Chooses the full film of a scene at rest.
    void chooseFull();
    int divider() const { return divider_; }  ///< see ResolutionLadder
    bool isCoarse() const { return divider_ > 1 || passing_; }
    /// Returns whether the film is coarse and tells the change of an edit, with the same random numbers as all such
    /// films of its size.
    bool isCoarseEdit() const { return ofEdit_ && divider_ > 1; }
    /// Records how long the film that was chosen took to begin [s].
    void addBeginning(double seconds);
    /// Starts with a film of that progress, and forgets the times of images. How coarse it is and what is known of the
    /// speed of samples stays.
    void reset(TileProgress progress);

    // Progress of the film:
    const Sweep& sweep() const { return sweep_; }
    SampleCounts samples() const { return sweep_.samples(); }
    /// Returns the time spent on samples that a part of the image has and the rest is still to get [s].
    double secondsAhead() const;
    const FrameTimer& timer() const { return timer_; }

    // The current frame:
    /// Returns whether the next samples begin a frame.
    bool isBetweenFrames() const { return !hasIterations() && !sweep_.isHalfMade(); }
    /// Returns whether the frame has iterations, which no image shows yet.
    bool hasIterations() const { return done_.n > 0; }
    /// Begins a frame of which all passes sample the cells around `part`. If work overlaps, some frames are timed
    /// alone: now and then, and always if the image is `fresh`, for another film or judgement.
    void beginFrame(const Tile& part, bool overlaps, bool fresh);
    /// Returns whether the frame is timed: it must be made and shown with nothing else in flight.
    bool isTimed() const { return isTimed_; }
    /// Returns the next samples to take. `inPieces`: a launch may sample some of the part's pixels only.
    Sweep::Order next(const Demand& demand, bool inPieces);
    /// Records that `order` was carried out in `seconds`.
    void took(const Sweep::Order& order, double seconds);
    /// Returns the number of iterations that a frame gets. It rises as the part gets smaller than the image.
    std::uint32_t wanted(const Demand& demand) const;
    /// Returns whether an image is to be shown now: the frame has its iterations, or is late.
    bool isComplete(const Demand& demand) const;
    double frameSeconds() const { return done_.seconds; }  ///< time spent on the frame so far [s]
    /// Ends the frame and returns its iterations.
    Iterations endFrame();

    /// Records the times of an image.
    void addImage(const TimedImage& image);
    /// Records the times of a timed frame of n iterations, which took `seconds` in all, its display `displaySeconds`.
    void addTimedFrame(std::uint32_t n, double seconds, double displaySeconds);

  private:
    double pixels() const;
    double partPixels() const;
    bool hurries(const Demand& demand) const { return isCoarse() && !demand.replaced; }
    double secondsForSamples() const;
    bool isLate() const;
    std::uint32_t launch(const Demand& demand) const;
    std::uint64_t leftToMark() const;
    std::uint32_t worthSending(std::uint32_t usual) const;

    SessionClock clock_;
    ResolutionLadder ladder_;
    FrameTimer timer_;
    int divider_ = 1;
    bool passing_ = false;  ///< the film was begun during a drag, with random numbers of its own
    bool ofEdit_ = false;   ///< the film is the first after an edit, coarse or not
    bool moving_ = false;   ///< such an edit is part of a drag

    Sweep sweep_;
    Iterations done_;     ///< iterations of the current frame
    bool isEven_ = true;  ///< those cover all pixels equally
    Iterations ahead_;    ///< iterations that only a part of the film got
    bool isTimed_ = false;
    double timedAt_ = 0;  ///< clock time of the last timed frame
};

}  // namespace pdr
