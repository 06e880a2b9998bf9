// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/form_rows.h"

#include "model/files/expression.h"
#include "model/world/shortest_number.h"
#include "views/author/refused_texts.h"
#include "views/boxes.h"
#include "views/icons.h"
#include "views/theme.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSplitter>
#include <QStyle>
#include <QToolButton>
#include <QVariant>

namespace cradle {

QLabel *makeHeading(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setFont(headingFont());
    setKind(label, "heading");
    return label;
}

QToolButton *makeIconButton(const QString &iconName, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setIcon(icon(iconName));
    button->setIconSize(iconSquare(16));
    button->setAutoRaise(true);
    return button;
}

void nameButton(QToolButton *button, const QString &name, const QString &keys)
{
    button->setAccessibleName(name);
    button->setToolTip(keys.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, keys));
}

QFormLayout *makeFormRows()
{
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    return form;
}

namespace {

struct FormText {
    Q_DECLARE_TR_FUNCTIONS(AuthorForms)
};

constexpr double mostPoints = 1000.0; ///< as in task.schema.json

/// nullptr if \p field has none.
QLabel *captionOf(const QWidget *field)
{
    for (QLabel *each :
         field->parentWidget()->findChildren<QLabel *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (each->buddy() == field)
            return each;
    }
    return nullptr;
}

} // namespace

QLabel *makeCaption(QWidget *field)
{
    auto *caption = new QLabel(field->parentWidget());
    caption->setBuddy(field);
    return caption;
}

QLabel *addField(QFormLayout *rows, QWidget *field)
{
    QLabel *caption = makeCaption(field);
    rows->addRow(caption, field);
    return caption;
}

void nameField(QWidget *field, const QString &caption, const QString &tip, const QString &spoken)
{
    if (QLabel *label = captionOf(field))
        label->setText(caption);
    field->setToolTip(tip);
    field->setAccessibleName(spoken.isEmpty() ? caption : spoken);
}

void showField(QWidget *field, bool visible)
{
    if (QLabel *label = captionOf(field))
        label->setVisible(visible);
    field->setVisible(visible);
}

QSplitter *makeSplitter(Qt::Orientation orientation, const QList<QWidget *> &parts,
                        const QList<int> &sizes)
{
    auto *splitter = new QSplitter(orientation);
    for (QWidget *part : parts)
        splitter->addWidget(part);
    splitter->setChildrenCollapsible(false);
    if (!sizes.isEmpty())
        splitter->setSizes(sizes);
    return splitter;
}

QSplitter *layOutSideBySide(QWidget *whole, const QList<QWidget *> &parts, const QList<int> &widths)
{
    QSplitter *splitter = makeSplitter(Qt::Horizontal, parts, widths);
    layOutColumn(whole, {}, -1, {splitter});
    return splitter;
}

QScrollArea *scrolled(QWidget *widget)
{
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setWidget(widget);
    scroll->setFocusPolicy(Qt::NoFocus); // what is in it has the keyboard
    return scroll;
}

QPlainTextEdit *makeFileText(const QString &name, QWidget *parent)
{
    auto *text = new QPlainTextEdit(parent);
    text->setFont(codeFont()); // first: a style sheet remembers what it was before
    setKind(text, "field");
    text->setObjectName(name);
    text->setLineWrapMode(QPlainTextEdit::NoWrap);
    text->setUndoRedoEnabled(false);
    text->setTabChangesFocus(true);
    return text;
}

QLabel *makeMutedText(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setWordWrap(true);
    setKind(label, "muted");
    return label;
}

QLabel *makeRefusal(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setWordWrap(true);
    setKind(label, "warning");
    label->hide();
    return label;
}

QLabel *makeRefusal(const RefusedTexts &texts, QWidget *parent)
{
    QLabel *label = makeRefusal(parent);
    QObject::connect(&texts, &RefusedTexts::changed, label,
                     [label, &texts] { showRefusal(label, texts.reason()); });
    return label;
}

void showRefusal(QLabel *label, const QString &reason)
{
    label->setText(reason);
    label->setVisible(!reason.isEmpty());
}

void markRefused(QWidget *field, bool refused)
{
    field->setProperty("refused", refused);
    field->style()->unpolish(field);
    field->style()->polish(field);
}

QString faultOfId(const QString &id)
{
    static const QRegularExpression form(QStringLiteral("^[A-Za-z0-9._-]{1,64}$"));
    return form.match(id).hasMatch()
               ? QString()
               : FormText::tr("An id of letters, digits, dots, dashes and underscores is right");
}

QString pointsText(double points)
{
    return points == 1.0 ? QString() : fractionOrNumber(points);
}

Result<double> pointsFrom(const QString &text)
{
    if (text.trimmed().isEmpty())
        return 1.0;
    const Result<double> points = evaluated(text);
    if (!points || *points < 0.0 || *points > mostPoints)
        return Error{.message = FormText::tr("Points: a number from 0 to 1000 is right")};
    return points;
}

void fillKindList(QComboBox *list, const std::vector<KindInfo> &kinds)
{
    list->clear();
    for (const KindInfo &kind : kinds) {
        list->addItem(kind.title, kind.name);
        list->setItemData(list->count() - 1, kind.purpose, Qt::ToolTipRole);
    }
}

} // namespace cradle
