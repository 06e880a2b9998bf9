// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/handles.h"
#include "views/scene/scene_builder.h"
#include "views/scene/scene_editor.h"
#include "views/scene/scene_picture.h"

#include <QPoint>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <memory>

class QAction;

namespace cradle {

class SceneActions;

/// What draws the scene.
enum class Renderer {
    Automatic, ///< OpenGL where a graphics card does it, else QPainter
    OpenGl,    ///< falls back to QPainter where OpenGL 3.3 cannot be had
    Raster     ///< QPainter
};

/// The scene of a preset and its run: shows the moment of the simulation, and lets circles and
/// their velocities be changed at the start of the run by pointer and keyboard.
class SceneView final : public QWidget
{
    Q_OBJECT
public:
    explicit SceneView(PresetDocument &document, QWidget *parent = nullptr);
    ~SceneView() override;

    void setRenderer(Renderer renderer);
    /// What is said where there is no circle; without it how the window's menu adds one.
    void setEmptyHint(const QString &hint) { m_emptyHint = hint; }
    [[nodiscard]] Renderer renderer() const { return m_renderer; }     ///< as set
    [[nodiscard]] Renderer activeRenderer() const { return m_active; } ///< never Automatic
    /// Why OpenGl was set but Raster is active; empty if it is as set.
    [[nodiscard]] QString fallbackReason() const { return m_fallbackReason; }
    /// Where shaders are read from at the next setRenderer(); tests make it fail with this.
    void setShaderFolder(const QString &folder) { m_shaderFolder = folder; }

    void setOptions(const SceneOptions &options);
    [[nodiscard]] const SceneOptions &options() const { return m_options; }
    /// Shows another run of the same scene beside this one, at the same moment: the outline of each
    /// circle where it would be, how far apart they are, and \p label, a word for what it is.
    /// \param ghost  null: none
    void setGhost(std::shared_ptr<const Recording> ghost, const QString &label);
    /// From now on this view, of the same document, shows what \p other is told to show, and draws
    /// it in the same way; what part of the scene it shows is its own.
    void showLike(const SceneView &other);
    [[nodiscard]] int selected() const { return m_editor.selected(); }
    [[nodiscard]] const std::vector<int> &selection() const { return m_editor.selection(); }
    [[nodiscard]] bool followsCentreOfMass() const { return m_follows; }
    /// What can be done with the selected circles, for menus.
    [[nodiscard]] const QList<QAction *> &circleActions() const;
    [[nodiscard]] const Camera &camera() const { return m_camera; }
    /// What is shown now.
    [[nodiscard]] const ScenePicture &picture();

    /// The scene at this moment in \p size logical pixels, without marks of selection and pointer.
    [[nodiscard]] ScenePicture plainPicture(QSizeF size) const;
    /// The same as an image, \p dpr device pixels to each.
    [[nodiscard]] QImage renderToImage(QSize size, qreal dpr = 1.0) const;

    [[nodiscard]] QSize sizeHint() const override { return {700, 700}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 200}; }

public slots:
    void select(int index); ///< -1: none; others stay selected if it was the last one already
    void addCircle(cradle::Vec2 at = {}) { m_editor.addCircle(at); }
    void fit();                       ///< shows the whole square
    void followCentreOfMass(bool on); ///< keeps it where it is in the picture, first in the middle
    void zoomIn();
    void zoomOut();
    void zoomToHit(); ///< that is shown; says so if there is none

signals:
    void selectionChanged(int index);
    void newRunRequested(); ///< from the moment shown
    void toldToShow();      ///< options, another run or a way to draw them

protected:
    bool event(QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    /// A button is down.
    struct Press {
        Qt::MouseButton button = Qt::NoButton;
        QPointF start{};
        QPointF last{};
        Handle handle{};
        bool moved = false;      ///< further than a click may
        bool bands = false;      ///< a rubber band is drawn from here
        bool singlesOut = false; ///< a mere click selects this one of the selected circles alone
    };

    void retranslate();
    void take(const SceneView &other);
    void refresh(); ///< something that is shown changed
    void installCanvas();
    void fallBack(const QString &reason);
    void followPreset();
    void describe();
    void notice(const QString &text);
    [[nodiscard]] SceneMoment moment() const; ///< that is shown, with its ghost
    [[nodiscard]] QString ghostText(const SceneMoment &moment) const;
    [[nodiscard]] QString exactText(const SceneMoment &moment) const;
    [[nodiscard]] QString mergedText(const SceneMoment &moment) const;
    [[nodiscard]] std::vector<Chip> chips(const SceneMoment &moment) const;
    [[nodiscard]] Handle handleUnder(QPointF pixel) const;
    void setHovered(Handle handle);
    void beginMove();
    void drag(QPointF pixel, bool snap);
    void endPress();
    void cancelMove();
    void selectWithin(const QRectF &band); ///< px; as well as what is selected
    bool nudge(const QKeyEvent &event);
    bool extendSelection(const QKeyEvent &event);
    void followCamera();
    [[nodiscard]] std::optional<MomentumInset> insetFor(const SceneMoment &seen,
                                                        const SceneLook &look) const;
    [[nodiscard]] std::optional<Loupe> loupeFor(const SceneMoment &seen, SceneLook &look) const;

    PresetDocument &m_document;
    SceneEditor m_editor;
    SceneActions *m_actions;
    SceneOptions m_options;
    std::shared_ptr<const Recording> m_ghost;
    QString m_ghostLabel;
    Camera m_camera;
    bool m_follows = false;
    Vec2 m_followed{}; ///< where the centre of mass was when the camera moved along last, m
    QPointer<QWidget> m_canvas; ///< child; none while it is being changed
    Renderer m_renderer = Renderer::Automatic;
    Renderer m_active = Renderer::Raster;
    QString m_fallbackReason;
    QString m_shaderFolder = QStringLiteral(":/shaders");
    ScenePicture m_picture;
    bool m_stale = true; ///< m_picture is older than what it shows
    bool m_focusFrame = false;

    Press m_press;
    Handle m_hovered;
    std::optional<HandleDrag> m_drag;
    QRectF m_band;                 ///< px; null if none is drawn
    std::vector<Circle> m_refused; ///< where the drag wants circles that cannot be there
    QString m_refusal;             ///< and why
    QString m_dragValue;
    QString m_emptyHint;
    QString m_notice;
    QTimer m_noticeTimer;
};

} // namespace cradle
