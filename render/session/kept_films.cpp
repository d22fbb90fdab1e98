/// How a kept film is found again, and which one goes when there are too many.

#include "render/session/kept_films.h"

#include <algorithm>
#include <utility>

#include "render/film/moments.h"

namespace pdr {

namespace {

/// Returns `scene` without what its film does not depend on, and without the volume, mask and label map. Whatever is
/// not named here counts, so that a field that is new in Scene cannot be forgotten.
Scene valuesOf(Scene scene) {
    scene.volume = nullptr;
    scene.mask = nullptr;
    scene.parts.map = nullptr;
    scene.visible = {};
    scene.ctDenoised = false;
    scene.maskAwaited = false;
    scene.revision = 0;
    scene.lookName.clear();
    return scene;
}

/// Returns whether both point, or pointed, to one object; two that never pointed to any do so, too.
template <class T>
bool sameObject(const std::weak_ptr<T>& a, const std::weak_ptr<T>& b) {
    return !a.owner_before(b) && !b.owner_before(a);
}

}  // namespace

KeptScene::KeptScene(const Scene& scene, bool texturesFilter)
    : values_(valuesOf(scene)),
      texturesFilter_(texturesFilter),
      masked_(scene.mask != nullptr),
      parted_(scene.parts.map != nullptr),
      volume_(scene.volume),
      mask_(scene.mask),
      map_(scene.parts.map) {}

bool KeptScene::operator==(const KeptScene& other) const {
    return sameObject(volume_, other.volume_) && sameObject(mask_, other.mask_) && sameObject(map_, other.map_) &&
           texturesFilter_ == other.texturesFilter_ && values_ == other.values_;
}

bool KeptScene::isGone() const {
    return volume_.expired() || (masked_ && mask_.expired()) || (parted_ && map_.expired());
}

std::size_t KeptFilm::bytes() const {
    const ivec2 size = film.film->size();
    const std::size_t film = std::size_t(size.x) * std::size_t(size.y) * (sizeof(Moments) + sizeof(PixelSums));
    const std::size_t image = frame ? frame->rgba.size() + (frame->errorMap ? frame->errorMap->bins.size() : 0) : 0;
    return film + image + quality.bytes() + edits.bytes();
}

void KeptFilms::keep(std::shared_ptr<const KeptFilm> film) {
    std::erase_if(films_, [](const auto& kept) { return kept->scene.isGone(); });
    const auto known = std::ranges::find_if(films_, [&](const auto& kept) { return kept->scene == film->scene; });
    if (known != films_.end()) {
        if ((*known)->film.film->samples().mean > film->film.film->samples().mean)
            film = *known;
        films_.erase(known);
    }
    films_.push_back(std::move(film));
    dropWhatExceeds();
}

void KeptFilms::limit(std::size_t mostBytes) {
    mostBytes_ = mostBytes;
    dropWhatExceeds();
}

void KeptFilms::dropWhatExceeds() {
    while (bytes() > mostBytes_)
        films_.pop_front();
}

std::shared_ptr<const KeptFilm> KeptFilms::find(const KeptScene& scene) {
    const auto known = std::ranges::find_if(films_, [&](const auto& kept) { return kept->scene == scene; });
    if (known == films_.end())
        return nullptr;
    std::rotate(known, known + 1, films_.end());
    return films_.back();
}

void KeptFilms::drop(const KeptScene& scene) {
    std::erase_if(films_, [&](const auto& kept) { return kept->scene == scene; });
}

std::size_t KeptFilms::bytes() const {
    std::size_t sum = 0;
    for (const auto& film : films_)
        sum += film->bytes();
    return sum;
}

}  // namespace pdr
