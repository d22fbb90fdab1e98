#pragma once
/// Edits of the parts of the scan, where they come from and how they are shown, as edits of the document. Parts of one
/// name change together.

#include <QObject>
#include <optional>
#include <vector>

#include "app/document/document.h"
#include "render/scene/part_styles.h"

namespace pdr::app {

/// Numbers of parts: 0 is the rest of the body, n is part n - 1 of the label map.
using PartNumbers = std::vector<int>;

class PartEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` must outlive this object.
    explicit PartEdits(Document& document) : document_(document) {}

  public slots:
    /// Takes parts of the scan, from `sources`, which take the place of all others. Without `parts` there are none, and
    /// `sources` are empty. One step to undo.
    void setParts(const pdr::app::PartSources& sources, const std::shared_ptr<const pdr::app::ScanParts>& parts);
    /// Reports that the requested parts will not come: there are those that the scene shows. No step to undo.
    void keepParts();
    /// Reports that no label map is open with the requested hash: the others of the parts are shown. No step to undo.
    void dropLabels();
    /// Each is one step to undo.
    void setState(const std::vector<int>& parts, pdr::PartState state);
    /// None: the colours of the curve. The rest of the body has no colour of its own.
    void setColour(const std::vector<int>& parts, const std::optional<pdr::vec3>& albedo);
    /// Takes the curve of look `index` of the document's looks; -1: that of all tissue, and its colours.
    void setLook(const std::vector<int>& parts, int index);

  private:
    template <class Change>
    PartStyles changed(const PartNumbers& parts, const Change& change) const;
    void set(PartStyles styles);
    void fallBackTo(const PartSources& sources);

    Document& document_;
};

}  // namespace pdr::app
