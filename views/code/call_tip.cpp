// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/call_tip.h"

#include "views/code/completion_popup.h"
#include "views/theme.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr int widest = 460; ///< px

/// The signature as HTML with argument \p number in bold; "..." stands for all further ones.
QString withArgument(const QString &signature, int number)
{
    const QString name = signature.section(u'(', 0, 0);
    QStringList arguments = signature.section(u'(', 1).chopped(1).split(u',');
    const auto last = static_cast<int>(arguments.size()) - 1;
    const bool more = arguments.back().trimmed() == QLatin1String("...");
    const int shown = more ? std::min(number, last) : number;
    for (int i = 0; i <= last; ++i) {
        QString &argument = arguments[i];
        argument = argument.trimmed().toHtmlEscaped();
        if (i == shown)
            argument = QStringLiteral("<b><font color=\"%2\">%1</font></b>")
                           .arg(argument, theme().accent.name());
    }
    return QStringLiteral("%1(%2)").arg(name.toHtmlEscaped(), arguments.join(QStringLiteral(", ")));
}

} // namespace

CallTip::CallTip(QWidget *window)
    : QFrame(window)
    , m_signature(new QLabel)
    , m_doc(new QLabel)
{
    setKind(this, "card");
    setAutoFillBackground(true);
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    m_signature->setFont(numericFont());
    m_signature->setTextFormat(Qt::RichText);
    m_doc->setTextFormat(Qt::PlainText);
    m_doc->setWordWrap(true);
    setKind(m_doc, "muted");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 5);
    column->setSpacing(1);
    column->addWidget(m_signature);
    column->addWidget(m_doc);
    hide();
}

void CallTip::showCall(const CallPlace &call, const QRect &place)
{
    m_call = call;
    m_signature->setText(withArgument(call.function.signature, call.argument));
    m_doc->setText(call.function.doc);
    m_doc->setVisible(!call.function.doc.isEmpty());
    const int doc = m_doc->fontMetrics().horizontalAdvance(call.function.doc) + 2;
    const int width = std::max(m_signature->sizeHint().width() + 4, std::min(doc, widest)) + 18;
    const int height = layout()->hasHeightForWidth() ? layout()->heightForWidth(width)
                                                     : layout()->sizeHint().height();
    setGeometry(placeBeside(place, {width, height}, parentWidget()->rect(), true));
    raise();
    show();
}

QString CallTip::text() const
{
    return m_call.function.signature + u'\n' + m_call.function.doc;
}

} // namespace cradle
