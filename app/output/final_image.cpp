#include "app/output/final_image.h"

#include "app/output/judged_image.h"
#include "render/base/errors.h"
#include "render/session/bias_measurements.h"

namespace pdr::app {
namespace {

/// Returns FinalImage::denoisingNote of a judged image.
const char* denoisingNote(const FinalOrder& order, JudgedImage& image) {
    if (!order.display.denoised)
        return nullptr;
    if (!canBeDenoised(order.scene))
        return "the image is not denoised: this model has no noise but at the pixels' edges.";
    if (!anyPng(order.outputs))
        return "nothing is denoised: OpenEXR files hold the film as it is.";
    if (!image.denoised())
        return "the image is not denoised, since it is not known to be better for it.";
    return image.shown().of == ErrorOf::denoised ? nullptr
                                                 : "how far the denoised image is off is not known: too few samples, "
                                                   "too little tissue, or light that few samples have found.";
}

/// Measures the bias and writes the files. The device holds another scene afterwards.
FinalImage finished(const FinalOrder& order, const TakenFilm& taken, Device& device, const std::stop_token& stop) {
    const BatchResult& result = taken.result;
    const auto bias = measureBias(order.scene, order.display, device, taken.biasSeconds, stop);
    const Rendered rendered{
        result.film, order.display, result.seconds, device.info().name, bias ? *bias : MeasuredBiases(), taken.checks};
    const bool keeps = order.whenStopped == WhenStopped::keep;
    const std::stop_token discarded = keeps ? std::stop_token() : stop;
    const Display display = order.display.withDenoised(order.display.denoised && anyPng(order.outputs));
    JudgedImage image(*taken.film, order.scene, display, rendered, discarded);
    const PaintOver paintOver = order.painter ? order.painter(image.shown()) : PaintOver();
    WrittenFiles written =
        writeFiles(order.outputs, [&](const auto& file) { return image.write(file, paintOver, discarded); });
    return {result,
            image.biases(),
            denoisingNote(order, image),
            std::move(written),
            taken.checks,
            bias ? std::nullopt : std::optional(bias.error())};
}

/// Takes samples until a stop.
Result<TakenFilm> takenFilm(const FinalOrder& order, Device& device, const FinalSteps& steps,
                            const std::stop_token& stop) {
    const Scene& scene = order.scene;
    if (auto ok = device.upload(scene); !ok)
        return ok.error();
    if (auto ready = steps.beforeSamples(); !ready)
        return ready.error();
    const auto film = device.film(scene.film, scene.revision, scene.schedule);
    if (!film)
        return film.error();
    const auto result =
        BatchRender(**film, order.stops, order.display.withDenoised(false), order.whenStopped).run(stop, steps.report);
    if (!result)
        return result.error();
    if (order.whenStopped == WhenStopped::discard && stop.stop_requested())
        return cancelled();
    const NodeChecks checks = steps.afterSamples();
    if (result->film.samplesPerPixel == 0)
        return Error{phrase("ended before the first sample: nothing was written"), "", ""};
    const auto known = (*film)->film();
    if (!known)
        return known.error();
    return TakenFilm{*known, *result, kBiasTimeShare * result->seconds, checks};
}

}  // namespace

Result<FinalImage> renderFinal(const FinalOrder& order, Device& device, const FinalSteps& steps,
                               const std::stop_token& stop) {
    const auto taken = order.taken ? Result<TakenFilm>(*order.taken) : takenFilm(order, device, steps, stop);
    if (!taken)
        return taken.error();
    return finished(order, *taken, device, stop);
}

}  // namespace pdr::app
