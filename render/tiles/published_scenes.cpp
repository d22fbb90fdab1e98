#include "render/tiles/published_scenes.h"

#include <utility>

namespace pdr {

std::uint64_t PublishedScenes::publish(Purpose purpose, std::shared_ptr<const Scene> scene) {
    return set(purpose == Purpose::viewport ? viewport_ : finalRender_, std::move(scene));
}

bool PublishedScenes::withdraw(std::uint64_t number) {
    PublishedScene& published = viewport_.number == number ? viewport_ : finalRender_;
    if (published.number != number || !published.scene)
        return false;
    set(published, nullptr);
    return true;
}

std::uint64_t PublishedScenes::set(PublishedScene& published, std::shared_ptr<const Scene> scene) {
    published.number = ++last_;
    published.scene = std::move(scene);
    return last_;
}

}  // namespace pdr
