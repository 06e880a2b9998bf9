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
        {QStringLiteral("cdot"), QT_TRANSLATE_NOOP("FormulaWords", "times")},
        {QStringLiteral("times"), QT_TRANSLATE_NOOP("FormulaWords", "times")},
        {QStringLiteral("le"), QT_TRANSLATE_NOOP("FormulaWords", "is at most")},
        {QStringLiteral("leq"), QT_TRANSLATE_NOOP("FormulaWords", "is at most")},
        {QStringLiteral("ge"), QT_TRANSLATE_NOOP("FormulaWords", "is at least")},
        {QStringLiteral("geq"), QT_TRANSLATE_NOOP("FormulaWords", "is at least")},
        {QStringLiteral("ne"), QT_TRANSLATE_NOOP("FormulaWords", "is not")},
        {QStringLiteral("neq"), QT_TRANSLATE_NOOP("FormulaWords", "is not")},
        {QStringLiteral("approx"), QT_TRANSLATE_NOOP("FormulaWords", "is about")},
        {QStringLiteral("to"), QT_TRANSLATE_NOOP("FormulaWords", "becomes")},
        {QStringLiteral("rightarrow"), QT_TRANSLATE_NOOP("FormulaWords", "becomes")},
        {QStringLiteral("pm"), QT_TRANSLATE_NOOP("FormulaWords", "plus or minus")},
        {QStringLiteral("sum"), QT_TRANSLATE_NOOP("FormulaWords", "the sum of")},
        {QStringLiteral("infty"), QT_TRANSLATE_NOOP("FormulaWords", "infinity")},
        {QStringLiteral("perp"), QT_TRANSLATE_NOOP("FormulaWords", "perpendicular")},
        {QStringLiteral("parallel"), QT_TRANSLATE_NOOP("FormulaWords", "parallel")},
        {QStringLiteral("circ"), QT_TRANSLATE_NOOP("FormulaWords", "degrees")},
        {QStringLiteral("prime"), QT_TRANSLATE_NOOP("FormulaWords", "prime")},
        {QStringLiteral("="), QT_TRANSLATE_NOOP("FormulaWords", "equals")},
        {QStringLiteral("+"), QT_TRANSLATE_NOOP("FormulaWords", "plus")},
        {QStringLiteral("-"), QT_TRANSLATE_NOOP("FormulaWords", "minus")},
        {QStringLiteral("−"), QT_TRANSLATE_NOOP("FormulaWords", "minus")},
        {QStringLiteral("/"), QT_TRANSLATE_NOOP("FormulaWords", "over")},
        {QStringLiteral("<"), QT_TRANSLATE_NOOP("FormulaWords", "is less than")},
        {QStringLiteral(">"), QT_TRANSLATE_NOOP("FormulaWords", "is more than")},
        {QStringLiteral("|"), QT_TRANSLATE_NOOP("FormulaWords", "bar")},
        {QStringLiteral("'"), QT_TRANSLATE_NOOP("FormulaWords", "prime")},
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
