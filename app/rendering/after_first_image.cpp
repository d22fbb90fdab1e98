#include "app/rendering/after_first_image.h"

#include <chrono>
#include <utility>

namespace pdr::app {

AfterFirstImage::AfterFirstImage() {
    constexpr auto kLate = std::chrono::seconds(5);
    late_.setSingleShot(true);
    late_.setInterval(kLate);
    connect(&late_, &QTimer::timeout, this, &AfterFirstImage::imageStands);
}

void AfterFirstImage::call(std::function<void()> work) {
    if (stands_)
        return work();
    waiting_ = std::move(work);
    if (!late_.isActive())
        late_.start();
}

void AfterFirstImage::imageStands() {
    stands_ = true;
    late_.stop();
    if (const auto work = std::exchange(waiting_, nullptr))
        work();
}

void AfterFirstImage::reset() {
    stands_ = false;
    late_.stop();
    waiting_ = nullptr;
}

}  // namespace pdr::app
