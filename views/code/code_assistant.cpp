// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_assistant.h"

#include "views/code/call_tip.h"
#include "views/code/completion.h"
#include "views/code/completion_popup.h"
#include "views/code/lua_area.h"

#include <QKeyEvent>

namespace cradle {

namespace {

constexpr int wantedLetters = 2; ///< before completions come by themselves

/// A child of the window that \p area is in at this moment.
template <typename Frame>
Frame *inWindow(QPointer<Frame> &frame, const LuaArea &area)
{
    if (!frame)
        frame = new Frame(area.window());
    else if (frame->parentWidget() != area.window())
        frame->setParent(area.window());
    return frame;
}

} // namespace

CodeAssistant::CodeAssistant(LuaArea *area)
    : QObject(area)
    , m_area(area)
{
    area->installEventFilter(this);
    connect(area, &QsciScintillaBase::SCN_CHARADDED, this, &CodeAssistant::handleCharacter);
    connect(area, &QsciScintillaBase::SCN_UPDATEUI, this, &CodeAssistant::follow);
}

CodeAssistant::~CodeAssistant()
{
    delete m_popup;
    delete m_tip;
}

bool CodeAssistant::isOpen() const
{
    return m_popup && m_popup->isVisible();
}

void CodeAssistant::hide()
{
    if (m_popup)
        m_popup->hide();
    if (m_tip)
        m_tip->hide();
}

void CodeAssistant::complete()
{
    if (!m_area->isReadOnly())
        offer(true);
}

void CodeAssistant::handleCharacter(int character)
{
    if (m_accepting || m_area->isReadOnly())
        return;
    m_typed = true;
    offer(false);
    if (character == '(' || (m_tip && m_tip->isVisible()))
        showCall();
}

/// Closes what no longer belongs to the place of the cursor.
void CodeAssistant::follow()
{
    if (isOpen() && !m_typed && !m_accepting) {
        if (m_area->cursor() < m_wordStart)
            m_popup->hide();
        else
            offer(true);
    }
    if (m_tip && m_tip->isVisible() && !m_typed)
        showCall();
    m_typed = false;
}

/// \param asked  by the user: however few letters there are
void CodeAssistant::offer(bool asked)
{
    const QByteArray before = m_area->bytesBefore();
    const auto place = completionPlace(before);
    const bool wanted = place
                        && (asked || place->begun.size() >= wantedLetters
                            || (place->known && place->begun.isEmpty() && !place->link.isNull()));
    std::vector<ApiWord> words;
    if (wanted)
        words = completions(*place, m_area->bytes());
    const bool done = words.size() == 1 && words.front().name == place->begun;
    if (words.empty() || done) {
        if (m_popup)
            m_popup->hide();
        return;
    }
    m_begun = place->begun;
    m_wordStart = m_area->cursor() - static_cast<long>(place->begun.toUtf8().size());
    CompletionPopup *popup = inWindow(m_popup, *m_area);
    connect(popup, &CompletionPopup::accepted, this, &CodeAssistant::accept, Qt::UniqueConnection);
    popup->showWords(words, placeInWindow(m_wordStart));
    if (m_tip && m_tip->isVisible() && m_tip->geometry().intersects(popup->geometry()))
        m_tip->hide();
}

void CodeAssistant::showCall()
{
    const QByteArray text = m_area->bytes();
    const auto cursor = m_area->cursor();
    const auto call =
        callPlace(QByteArrayView(text).first(cursor), QByteArrayView(text).sliced(cursor));
    if (!call) {
        if (m_tip)
            m_tip->hide();
        return;
    }
    inWindow(m_tip, *m_area)->showCall(*call, placeInWindow(cursor));
}

void CodeAssistant::accept()
{
    const QByteArray word = m_popup->chosen().toUtf8();
    m_popup->hide();
    m_accepting = true;
    m_area->beginUndoAction();
    m_area->replaceBytes(m_wordStart, m_area->cursor(), word);
    m_area->SendScintilla(QsciScintillaBase::SCI_GOTOPOS, m_wordStart + long(word.size()));
    m_area->endUndoAction();
    m_accepting = false;
    m_area->setFocus();
}

QRect CodeAssistant::placeInWindow(long position) const
{
    const QRect place = m_area->placeOf(position);
    return {m_area->viewport()->mapTo(m_area->window(), place.topLeft()), place.size()};
}

bool CodeAssistant::handlePopupKey(const QKeyEvent &event)
{
    switch (event.key()) {
    case Qt::Key_Up:
        m_popup->move(-1);
        return true;
    case Qt::Key_Down:
        m_popup->move(1);
        return true;
    case Qt::Key_PageUp:
        m_popup->move(-m_popup->rowsOnPage());
        return true;
    case Qt::Key_PageDown:
        m_popup->move(m_popup->rowsOnPage());
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (m_popup->chosen() == m_begun) { // it is all there: the line ends
            m_popup->hide();
            return false;
        }
        accept();
        return true;
    case Qt::Key_Tab:
        accept();
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
        m_popup->hide();
        return false;
    default:
        return false;
    }
}

bool CodeAssistant::handleKey(const QKeyEvent &event)
{
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    if (event.key() == Qt::Key_Space && modifiers == Qt::ControlModifier) {
        complete();
        return true;
    }
    if (event.key() == Qt::Key_Space && modifiers == (Qt::ControlModifier | Qt::ShiftModifier)) {
        showCall();
        return true;
    }
    if (event.key() == Qt::Key_Escape && (isOpen() || (m_tip && m_tip->isVisible()))) {
        hide();
        return true;
    }
    return isOpen() && modifiers == Qt::NoModifier && handlePopupKey(event);
}

bool CodeAssistant::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: {
        const auto &key = *static_cast<QKeyEvent *>(event);
        const bool space = key.key() == Qt::Key_Space && key.modifiers() & Qt::ControlModifier;
        if (space || (key.key() == Qt::Key_Escape && isOpen())) {
            event->accept();
            return true;
        }
        break;
    }
    case QEvent::KeyPress:
        if (handleKey(*static_cast<QKeyEvent *>(event)))
            return true;
        break;
    case QEvent::FocusOut:
    case QEvent::Hide:
    case QEvent::Resize:
    case QEvent::Wheel:
    case QEvent::MouseButtonPress:
        hide();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace cradle
