#pragma once
/// The controls for an environment image that lights the volume, a sky or a room: it is chosen from a file, turned
/// about the patient, and removed. Setters emit no signals.

#include <QPushButton>
#include <QSlider>
#include <QWidget>

#include "render/scene/light.h"

namespace pdr::ui {

class SkyRow : public QWidget {
    Q_OBJECT

  public:
    explicit SkyRow(QWidget* parent = nullptr);

    void setEnvironment(const Environment& environment);

  signals:
    void skyChosen(const QString& file);
    /// Reports an edited environment. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void environmentEdited(const pdr::Environment& environment, bool moving);

  private:
    void ask();
    void turn();

    Environment environment_;
    QPushButton choose_;
    QPushButton remove_;
    QWidget turnRow_;
    QSlider turn_{Qt::Horizontal};  ///< degrees
};

}  // namespace pdr::ui
