#pragma once
/// Films of earlier scenes, put away with all their samples, so that a scene that comes back need not be rendered
/// again: after undo and redo, a look or a view chosen before. The films used longest ago go first.

#include <cstddef>
#include <deque>
#include <memory>

#include "render/scene/scene.h"
#include "render/session/edited_view.h"
#include "render/session/film_on_device.h"
#include "render/session/quality_tracker.h"
#include "render/session/session.h"

namespace pdr {

/// Everything of a scene that the samples of its film depend on. It holds no volume, mask or label map: these are
/// too large to stay for an image that is not shown.
class KeptScene {
  public:
    /// `texturesFilter`: see known_bias.h; texture units take other samples of the same scene.
    KeptScene(const Scene& scene, bool texturesFilter);

    /// Returns whether both have the same samples. Volumes, masks, label maps and images of the environment are the
    /// same if they are one object; all else is compared value by value.
    bool operator==(const KeptScene& other) const;
    /// Returns whether its volume, mask or label map exists no longer, so that it cannot come back.
    bool isGone() const;

  private:
    Scene values_;  ///< without volume, mask, and what no image depends on
    bool texturesFilter_;
    bool masked_, parted_;
    std::weak_ptr<const Volume> volume_;
    std::weak_ptr<const Mask> mask_;     ///< empty without a mask
    std::weak_ptr<const LabelMap> map_;  ///< empty without parts
};

/// A film that was put away, and what was known of its images.
struct KeptFilm {
    KeptScene scene;
    AttestedFilm film;
    std::shared_ptr<const Frame> frame;  ///< last image that was shown of it; null: none
    QualityTracker quality;
    EditedView::ForNext edits;

    /// Returns the memory that it takes.
    std::size_t bytes() const;
};

class KeptFilms {
  public:
    /// Most memory that they take together, unless told otherwise [bytes].
    static constexpr std::size_t kMostBytes = std::size_t(1) << 30;

    explicit KeptFilms(std::size_t mostBytes = kMostBytes) : mostBytes_(mostBytes) {}
    /// Sets the most memory [bytes].
    void limit(std::size_t mostBytes);

    /// Takes a film; of two films of one scene the one with fewer samples is dropped. Then films go, those used longest
    /// ago first, until the rest is within the limit; a film that exceeds it alone is not kept.
    void keep(std::shared_ptr<const KeptFilm> film);
    /// Returns the film of that scene, which stays, as the one used last; null: none.
    std::shared_ptr<const KeptFilm> find(const KeptScene& scene);
    /// Drops the film of that scene, if there is one.
    void drop(const KeptScene& scene);
    /// Drops all films.
    void clear() { films_.clear(); }
    /// Returns the memory that they take together.
    std::size_t bytes() const;

  private:
    void dropWhatExceeds();

    std::size_t mostBytes_;
    std::deque<std::shared_ptr<const KeptFilm>> films_;  ///< the one used last is the last
};

}  // namespace pdr
