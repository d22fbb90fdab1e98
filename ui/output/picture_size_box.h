#pragma once
/// How large a picture is to be that is saved, and how good: as it is on the screen, or made anew; and what is written
/// over it.

#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>
#include <optional>

#include "ui/output/picture_order.h"
#include "ui/widgets/stop_row.h"

namespace pdr::ui {

class PictureSizeBox : public QWidget {
    Q_OBJECT

  public:
    explicit PictureSizeBox(const PictureOffer& offer, QWidget* parent = nullptr);

    /// None: as it is on the screen.
    std::optional<QSize> chosenSize() const;
    StopRule stop() const { return stop_->rule(); }
    Annotate annotate() const;
    /// Files of radiance carry no annotations.
    void setAnnotatable(bool annotatable);

  private:
    void takeSize();
    void takeNumbers();
    void showCost();

    std::optional<PictureCost> cost_;
    QComboBox* sizes_;
    QSpinBox* width_;
    QSpinBox* height_;
    StopRow* stop_;
    QLabel* takes_;
    QComboBox* annotate_;
};

}  // namespace pdr::ui
