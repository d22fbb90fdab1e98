#pragma once
/// How large a picture is to be that is saved, and how good: as it is on the screen, or made anew.

#include <QComboBox>
#include <QSpinBox>
#include <QWidget>
#include <optional>

#include "ui/stop_row.h"

namespace pdr::ui {

class PictureSizeBox : public QWidget {
    Q_OBJECT

  public:
    /// `view`: the size on the screen [pixels]; `stop`: what is wanted there. Both are what a new picture starts from.
    PictureSizeBox(QSize view, const StopRule& stop, QWidget* parent = nullptr);

    /// None: as it is on the screen.
    std::optional<QSize> chosenSize() const;
    StopRule stop() const { return stop_->rule(); }

  private:
    void takeSize();
    void takeNumbers();

    QComboBox* sizes_;
    QSpinBox* width_;
    QSpinBox* height_;
    StopRow* stop_;
};

}  // namespace pdr::ui
