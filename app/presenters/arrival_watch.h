#pragma once
/// Keeps the slices up to date while a volume arrives, and shows one in place of the image if that will take long.

#include <QElapsedTimer>
#include <QTimer>

#include "app/presenters/workspace.h"

namespace pdr::app {

class ArrivalWatch : public QObject {
    Q_OBJECT

  public:
    /// `axial`: the view that stands in for the image. `workspace` and it must outlive this object.
    ArrivalWatch(const Workspace& workspace, QWidget& axial);

    /// Begins to watch Document::arriving().
    void begin();
    /// Ends it, and gives the image its place back, unless the user has changed what is shown.
    void end();

  signals:
    /// Emitted now and then: more slices may have arrived.
    void more();

  private:
    void standIn();

    const Workspace& workspace_;
    QWidget& axial_;
    QTimer often_;
    QElapsedTimer sinceBegin_;
    bool standsIn_ = false;  ///< whether the slice was shown in place of the image
};

}  // namespace pdr::app
