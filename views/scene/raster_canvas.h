// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_picture.h"

#include <QWidget>

#include <functional>

namespace cradle {

/// Gives the picture to show now; asked once for each repaint.
using PictureSource = std::function<const ScenePicture &()>;

/// Shows the scene with QPainter.
class RasterCanvas final : public QWidget
{
    Q_OBJECT
public:
    explicit RasterCanvas(PictureSource source, QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    PictureSource m_source;
};

} // namespace cradle
