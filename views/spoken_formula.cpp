// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/spoken_formula.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>

namespace cradle {

namespace {

struct FormulaWords {
    Q_DECLARE_TR_FUNCTIONS(FormulaWords)
};

/// Said in the language in force; Greek letters and functions that are not here by their name.
QString wordFor(const QString &command)
{
    static const QHash<QString, const char *> words{
        {QStringLiteral("cdot"), QT_TR_NOOP("times")},
        {QStringLiteral("times"), QT_TR_NOOP("times")},
        {QStringLiteral("le"), QT_TR_NOOP("is at most")},
        {QStringLiteral("leq"), QT_TR_NOOP("is at most")},
        {QStringLiteral("ge"), QT_TR_NOOP("is at least")},
        {QStringLiteral("geq"), QT_TR_NOOP("is at least")},
        {QStringLiteral("ne"), QT_TR_NOOP("is not")},
        {QStringLiteral("neq"), QT_TR_NOOP("is not")},
        {QStringLiteral("approx"), QT_TR_NOOP("is about")},
        {QStringLiteral("to"), QT_TR_NOOP("becomes")},
        {QStringLiteral("rightarrow"), QT_TR_NOOP("becomes")},
        {QStringLiteral("pm"), QT_TR_NOOP("plus or minus")},
        {QStringLiteral("sum"), QT_TR_NOOP("the sum of")},
        {QStringLiteral("infty"), QT_TR_NOOP("infinity")},
        {QStringLiteral("perp"), QT_TR_NOOP("perpendicular")},
        {QStringLiteral("parallel"), QT_TR_NOOP("parallel")},
        {QStringLiteral("circ"), QT_TR_NOOP("degrees")},
        {QStringLiteral("prime"), QT_TR_NOOP("prime")},
        {QStringLiteral("="), QT_TR_NOOP("equals")},
        {QStringLiteral("+"), QT_TR_NOOP("plus")},
        {QStringLiteral("-"), QT_TR_NOOP("minus")},
        {QStringLiteral("−"), QT_TR_NOOP("minus")},
        {QStringLiteral("/"), QT_TR_NOOP("over")},
        {QStringLiteral("<"), QT_TR_NOOP("is less than")},
        {QStringLiteral(">"), QT_TR_NOOP("is more than")},
        {QStringLiteral("|"), QT_TR_NOOP("bar")},
        {QStringLiteral("'"), QT_TR_NOOP("prime")},
    };
    static const QStringList silent{
        QStringLiteral("left"), QStringLiteral("right"), QStringLiteral("big"),
        QStringLiteral("Big"),  QStringLiteral("bigl"),  QStringLiteral("bigr"),
        QStringLiteral("quad"), QStringLiteral("qquad"), QStringLiteral("displaystyle")};
    const auto known = words.constFind(command);
    if (known != words.constEnd())
        return FormulaWords::tr(*known);
    return silent.contains(command) ? QString() : command;
}

/// Reads a formula from left to right; a part is a group, a command or one character.
class Speaker
{
public:
    explicit Speaker(const QString &tex)
        : m_tex(tex)
    {
    }

    QString all(QChar end = {})
    {
        QStringList said;
        while (m_at < m_tex.size() && (end.isNull() || m_tex[m_at] != end)) {
            const QString part = next();
            if (!part.isEmpty())
                said.append(part);
        }
        ++m_at; // past the end of the group
        return said.join(QLatin1Char(' '));
    }

private:
    QString next()
    {
        const QChar c = m_tex[m_at++];
        if (c == u'\\')
            return command();
        if (c == u'{')
            return all(u'}');
        if (c == u'_')
            return FormulaWords::tr("sub %1").arg(argument());
        if (c == u'^')
            return power();
        if (c == u'&' || c == u'~' || c == u'}' || c.isSpace())
            return {};
        if (c.isDigit() || c == u'.') {
            const qsizetype start = m_at - 1;
            while (m_at < m_tex.size() && (m_tex[m_at].isDigit() || m_tex[m_at] == u'.'))
                ++m_at;
            return m_tex.mid(start, m_at - start);
        }
        return wordFor(QString(c));
    }

    QString argument()
    {
        while (m_at < m_tex.size() && m_tex[m_at].isSpace())
            ++m_at;
        return m_at < m_tex.size() ? next() : QString();
    }

    QString power()
    {
        const QString exponent = argument();
        if (exponent == QLatin1String("2"))
            return FormulaWords::tr("squared");
        if (exponent == QLatin1String("3"))
            return FormulaWords::tr("cubed");
        if (exponent == FormulaWords::tr("prime") || exponent == FormulaWords::tr("degrees"))
            return exponent;
        return FormulaWords::tr("to the power of %1").arg(exponent);
    }

    QString command()
    {
        const qsizetype start = m_at;
        while (m_at < m_tex.size() && m_tex[m_at].isLetter())
            ++m_at;
        if (m_at == start) { // a space such as \, or an escaped sign
            const QChar sign = m_at < m_tex.size() ? m_tex[m_at++] : QChar();
            return sign == u'|' ? wordFor(QString(sign)) : sign == u'%' ? QString(sign) : QString();
        }
        const QString name = m_tex.mid(start, m_at - start);
        if (name == QLatin1String("frac") || name == QLatin1String("tfrac")
            || name == QLatin1String("dfrac")) {
            const QString above = argument();
            return FormulaWords::tr("%1 over %2", "a fraction").arg(above, argument());
        }
        if (name == QLatin1String("sqrt"))
            return FormulaWords::tr("the square root of %1").arg(argument());
        if (name == QLatin1String("vec") || name == QLatin1String("mathbf")
            || name == QLatin1String("boldsymbol"))
            return FormulaWords::tr("vector %1").arg(argument());
        if (name == QLatin1String("hat"))
            return FormulaWords::tr("unit vector %1").arg(argument());
        if (name == QLatin1String("text") || name == QLatin1String("mathrm")
            || name == QLatin1String("operatorname"))
            return verbatim();
        return wordFor(name);
    }

    /// The text of a group as it is written.
    QString verbatim()
    {
        const qsizetype open = m_tex.indexOf(u'{', m_at);
        const qsizetype close = m_tex.indexOf(u'}', m_at);
        if (open != m_at || close < 0)
            return argument();
        m_at = close + 1;
        return m_tex.mid(open + 1, close - open - 1).trimmed();
    }

    const QString &m_tex;
    qsizetype m_at = 0;
};

} // namespace

QString spokenFormula(const QString &tex)
{
    return Speaker(tex).all();
}

} // namespace cradle
