#pragma once
/// The looks to choose from, as they are for the scan that is shown.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/named_look.h"
#include "render/scene/picture_setup.h"
#include "render/segment/findings.h"

namespace pdr::app {

class FittedLooks {
  public:
    /// `drawn` holds at least one.
    explicit FittedLooks(std::vector<NamedLook> drawn);

    /// Curves for contrast lie where the scan's blood does.
    const std::vector<NamedLook>& fitted() const { return fitted_; }
    const std::vector<NamedLook>& drawn() const { return drawn_; }
    const NamedLook& operator[](int look) const { return fitted_[std::size_t(look)]; }
    bool holds(int look) const { return look >= 0 && look < int(fitted_.size()); }

    /// Others to choose from, of the same scan. `drawn` holds at least one.
    void replace(std::vector<NamedLook> drawn);
    /// Another scan, as far as it is known. No brightness is known of it.
    void fitTo(const std::optional<segment::Findings>& findings);

    /// Why a look makes no sense of the scan; empty: it does, or nothing is known of it.
    std::string whyUnsuited(int look) const;
    /// `look` where it makes sense of the scan; otherwise the first that does, or where none does, `look` as well.
    int suitedOr(int look) const;

    /// The look that a setup shows; -1: a changed one.
    int indexOf(const PictureSetup& setup) const;
    /// `setup`, which came out of one whose look was called `before`, under the name of the look that it shows, or as
    /// that one changed: a picture must not bear the name of a look that it does not show.
    PictureSetup named(PictureSetup setup, const std::string& before) const;
    /// The look that a setup shows, or the one that it was before it was changed; null: there is none.
    const NamedLook* beginningOf(const PictureSetup& setup) const { return lookCalled(setup.lookName); }
    /// Null: there is none.
    const NamedLook* lookCalled(const std::string& name) const;

    /// [stops] that suit the scan under a look; 0: not known yet.
    double stops(int look) const { return stops_[std::size_t(look)].value_or(0); }
    /// The first suggestion counts. False where there was one, and for the user's own looks, whose brightness somebody
    /// has chosen.
    bool suggestStops(int look, double stops);

  private:
    void fit();

    std::vector<NamedLook> drawn_;
    std::vector<NamedLook> fitted_;
    std::vector<std::optional<double>> stops_;
    std::optional<segment::Findings> findings_;
};

}  // namespace pdr::app
