#include "render/edit/kept_image.h"

#include "render/edit/light_change.h"

namespace pdr {

std::shared_ptr<const KeptImage> keptImage(const NoisyFilm& noisy, const SmoothHalves& denoised, std::uint64_t samples,
                                           const FirstSamples& first) {
    const auto unit = float(noisy.unit);
    SmoothHalves halves{scaled(denoised.even, unit), scaled(denoised.odd, unit)};
    denoise::Colours all = meanOf(halves.even, halves.odd);
    return std::make_shared<const KeptImage>(KeptImage{samples, std::move(halves), std::move(all), first});
}

}  // namespace pdr
