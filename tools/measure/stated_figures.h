#pragma once
/// Computes what an image states about its error, and how much of the truth that covers.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "render/accuracy/forecast.h"
#include "render/device/device.h"
#include "render/film/display/denoised_view.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/likely_error.h"
#include "render/film/error/local_error.h"
#include "render/film/error/noisy_film.h"
#include "render/film/tone_curve.h"
#include "tools/measure/slack.h"

namespace pdr::test {

constexpr double kSigmas = 1.96;

/// An image, row by row, and all that is stated about it.
struct StatedImage {
    FilmStatus status;
    std::optional<DenoisedError> denoisedError;
    std::vector<dvec3> light, denoised;
    std::vector<dvec3> error, bound;      ///< as in an OpenEXR file
    std::vector<float> map, denoisedMap;  ///< levels; infinite: not known, or beyond the map's range
    std::vector<bool> tissue;
};

inline dvec3 at(const denoise::Colours& planes, int x, int y) {
    return {planes[0].row(y)[x], planes[1].row(y)[x], planes[2].row(y)[x]};
}

/// Returns the levels of a map as it is painted.
inline std::vector<float> shownLevels(const LevelErrorMap& map) {
    std::vector<float> shown;
    for (const std::uint8_t bin : map.bins)
        shown.push_back(bin < kLastBin ? float(levelsOfBin(bin)) : std::numeric_limits<float>::infinity());
    return shown;
}

inline StatedImage statedImage(const Film& film, const Tone& tone) {
    StatedImage image{.status = film.status(tone)};
    DenoisedView view;
    view.judge(film, film.samplesPerPixel(), {});
    image.denoisedError = view.error(tone);
    if (const auto map = view.errorMap(tone))
        image.denoisedMap = shownLevels(*map);
    image.map = shownLevels(levelErrorMap(film, tone));
    const NoisyFilm noisy = noisyFilm(film);
    const denoise::Colours denoised = smoothRadiance(noisy), bounds = localErrors(film),
                           errors = likelyErrors(film, wholeImage(film.size()));
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x) {
            const PixelEstimate pixel = film.pixel(x, y);
            image.light.push_back(pixel.mean);
            image.denoised.push_back(noisy.unit * at(denoised, x, y));
            image.error.push_back(at(errors, x, y));
            image.bound.push_back(at(bounds, x, y));
            image.tissue.push_back(pixel.tissue);
        }
    return image;
}

/// The mean of the images of many seeds.
class Truth {
  public:
    explicit Truth(std::size_t pixels) : sum_(pixels), tissue_(pixels) {}

    void add(const StatedImage& image) {
        ++images_;
        for (std::size_t i = 0; i < sum_.size(); ++i) {
            sum_[i] += image.light[i];
            tissue_[i] = tissue_[i] || image.tissue[i];
        }
    }
    /// The mean of all images that were added but one.
    struct Known {
        std::vector<dvec3> light;
        const std::vector<bool>& tissue;
    };
    Known without(const StatedImage& image) const {
        Known known{sum_, tissue_};
        for (std::size_t i = 0; i < sum_.size(); ++i)
            known.light[i] = (sum_[i] - image.light[i]) / (images_ - 1);
        return known;
    }

  private:
    double images_ = 0;
    std::vector<dvec3> sum_;
    std::vector<bool> tissue_;
};

/// The prediction of the samples at which the error is 0.6 of what it was.
class Forecast {
  public:
    void look(const FilmStatus& now, std::uint64_t from) {
        history_.add(double(now.samplesPerPixel), now);
        if (now.samplesPerPixel == from && std::isfinite(now.displayError) && now.displayError > 0) {
            target_ = 0.6 * now.displayError;
            foretold_ = history_.samples(target_);
        }
        if (target_ > 0 && !needed_ && now.displayError <= target_)
            needed_ = double(now.samplesPerPixel);
        last_ = double(now.samplesPerPixel);
    }
    /// Returns whether the prediction came true; nothing if none was made. A prediction that is still open at the end
    /// is true if it reaches beyond the end.
    std::optional<bool> cameTrue() const {
        if (target_ <= 0)
            return std::nullopt;
        return needed_ ? *needed_ >= foretold_.low && *needed_ <= foretold_.high : foretold_.high > last_;
    }

  private:
    ErrorHistory history_;
    double target_ = 0, last_ = 0;
    Foretold foretold_;
    std::optional<double> needed_;
};

/// The share of cases that hold.
struct Share {
    double held = 0, all = 0;

    void add(bool one) { held += one, ++all; }
    std::string text() const {
        std::ostringstream out;
        if (all > 0) {
            out.precision(1);
            out << std::fixed << 100 * held / all;
        }
        return out.str();
    }
};

constexpr const char* kFigureNames =
    "sentence,denoised,at_most,strip,map,denoised_map,error,bound,unknown,unmet,unmet_stated,ratio,images_denoised,"
    "slack";

/// The figures over the images of one scene and number of samples.
struct Figures {
    Share sentence, denoised, atMost, strip, map, denoisedMap, error, bound, unknown, unmet, unmetStated, judged;
    double squares = 0, statedSquares = 0;
    double truthNoise = 0;  ///< mean square of the truth's noise [levels²]
    Slack slack;

    /// Sets truthNoise from the images that the truths are made of, all but one each.
    void setTruthNoise(const std::vector<const StatedImage*>& best, const Truth& all, const Tone& tone) {
        double sum = 0, pixels = 0;
        for (const StatedImage* image : best) {
            const Truth::Known others = all.without(*image);
            for (std::size_t i = 0; i < image->light.size(); ++i)
                if (image->tissue[i]) {
                    const double off = double(levelsOff(image->light[i], others.light[i], tone));
                    sum += off * off, ++pixels;
                }
        }
        truthNoise = pixels > 0 ? sum / pixels / double(best.size()) : 0;
    }
    void add(const StatedImage& image, const Truth::Known& truth, const Tone& tone) {
        std::vector<float> levels;
        std::vector<double> denoisedLevels;
        double square = 0, light = 0;
        for (std::size_t i = 0; i < image.light.size(); ++i) {
            if (truth.tissue[i])
                unmet.add(!image.tissue[i]);
            if (!image.tissue[i])
                continue;
            levels.push_back(levelsOff(image.light[i], truth.light[i], tone));
            const double off = luminance(image.light[i] - truth.light[i]);
            square += off * off, light += luminance(truth.light[i]);
            addPixel(image, truth, i, levels.back());
            denoisedLevels.push_back(double(levelsOff(image.denoised[i], truth.light[i], tone)));
            addDenoised(image, i, float(denoisedLevels.back()));
        }
        if (image.denoisedError)
            slack.add(image.denoisedError->levelsAtMost, denoisedLevels, truthNoise);
        unmetStated.held += image.status.unseenTissue, ++unmetStated.all;
        judged.add(image.denoisedError.has_value());
        addSentence(image.status, levels);
        if (const double count = double(levels.size()); count > 0 && std::isfinite(image.status.relativeError)) {
            squares += square / count / std::pow(light / count, 2);
            statedSquares += image.status.relativeError * image.status.relativeError;
        }
    }
    /// Returns the figures as text, in the order of kFigureNames.
    std::string text() const {
        std::ostringstream out;
        for (const Share* share : {&sentence, &denoised, &atMost, &strip, &map, &denoisedMap, &error, &bound, &unknown,
                                   &unmet, &unmetStated})
            out << share->text() << ",";
        out.precision(3);
        if (statedSquares > 0)
            out << std::sqrt(squares / statedSquares);
        out << "," << judged.text() << ",";
        if (const std::optional<double> times = slack.median())
            out << *times;
        return out.str();
    }

  private:
    static float levelsOff(dvec3 light, dvec3 truth, const Tone& tone) {
        return pdr::levelsOff(displayTransform(tone), truth, light - truth);
    }
    void addPixel(const StatedImage& image, const Truth::Known& truth, std::size_t i, float levels) {
        const bool known = std::isfinite(image.error[i].y);
        unknown.add(!known);
        if (!known)
            return;
        if (std::isfinite(image.status.displayError))
            map.add(levels <= image.map[i]);
        const dvec3 off = glm::abs(image.light[i] - truth.light[i]);
        for (int c = 0; c < 3; ++c) {
            error.add(off[c] <= kSigmas * image.error[i][c]);
            bound.add(off[c] <= kSigmas * image.bound[i][c]);
        }
    }
    void addDenoised(const StatedImage& image, std::size_t i, float levels) {
        if (!image.denoisedError)
            return;
        denoisedMap.add(levels <= image.denoisedMap[i]);
        denoised.add(double(levels) <= image.denoisedError->levels);
        atMost.add(double(levels) <= image.denoisedError->levelsAtMost);
    }
    void addSentence(const FilmStatus& status, const std::vector<float>& levels) {
        if (!std::isfinite(status.displayError))
            return;
        for (const float one : levels)
            sentence.add(double(one) <= status.displayError);
    }
};

}  // namespace pdr::test
