// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/expression.h"

#include "model/files/expression_functions.h"
#include "model/files/unit_number.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace cradle {

namespace {

struct ExpressionText {
    Q_DECLARE_TR_FUNCTIONS(Expression)
};

constexpr qsizetype longest = 400;
constexpr int deepest = 50; ///< parentheses inside each other

Error noNumber(const QString &text, const QString &why)
{
    return {.message = ExpressionText::tr("“%1” is no number: %2").arg(text.left(60), why)};
}

/// Reads one expression; used once. The first fault ends it.
class Reader
{
public:
    Reader(const QString &text, const QMap<QString, double> &values)
        : m_text(text)
        , m_values(values)
    {
    }

    Result<UnitNumber> read()
    {
        const UnitNumber value = sum();
        if (m_fault.isEmpty() && m_at < m_text.size())
            fail(ExpressionText::tr("“%1” is not expected there").arg(m_text.mid(m_at, 12)));
        if (m_fault.isEmpty() && !std::isfinite(value.number))
            fail(ExpressionText::tr("it comes to no finite number"));
        if (m_fault.isEmpty())
            return value;
        return noNumber(m_text, m_fault);
    }

private:
    UnitNumber fail(const QString &fault)
    {
        if (m_fault.isEmpty())
            m_fault = fault;
        m_at = m_text.size();
        return {};
    }

    void skipSpace()
    {
        while (m_at < m_text.size() && m_text[m_at].isSpace())
            ++m_at;
    }

    bool takes(char letter)
    {
        skipSpace();
        if (m_at >= m_text.size() || m_text[m_at] != QLatin1Char(letter))
            return false;
        ++m_at;
        return true;
    }

    /// Of the sort of both; a fault if their units are not of one sort.
    UnitNumber together(const UnitNumber &a, const UnitNumber &b, double number)
    {
        return a.fits(b) ? likeBoth(a, b, number)
                         : fail(ExpressionText::tr("%1 and %2 stand side by side")
                                    .arg(nameOf(a.powers), nameOf(b.powers)));
    }

    UnitNumber sum()
    {
        UnitNumber value = product();
        for (;;) {
            const bool plus = takes('+');
            if (!plus && !takes('-'))
                return value;
            const UnitNumber next = product();
            value = together(value, next, value.number + (plus ? next.number : -next.number));
        }
    }

    UnitNumber product()
    {
        UnitNumber value = signedPower();
        for (;;) {
            const bool times = takes('*');
            if (!times && !takes('/'))
                return value;
            value = timesPower(value, signedPower(), times ? 1 : -1);
        }
    }

    UnitNumber signedPower()
    {
        if (++m_depth > deepest)
            return fail(ExpressionText::tr("it is too deep"));
        UnitNumber value;
        if (takes('-')) {
            value = signedPower();
            value.number = -value.number;
        } else if (takes('+')) {
            value = signedPower();
        } else {
            value = atom();
            if (takes('^'))
                value = power(value, signedPower());
        }
        --m_depth;
        return value;
    }

    UnitNumber power(const UnitNumber &base, const UnitNumber &exponent)
    {
        const auto value = raised(base, exponent);
        return value ? *value : fail(ExpressionText::tr("a power with that unit is none"));
    }

    UnitNumber atom()
    {
        if (takes('(')) {
            const UnitNumber value = sum();
            return takes(')') ? withUnit(value)
                              : fail(ExpressionText::tr("a closing parenthesis is missing"));
        }
        static const QString digits =
            QStringLiteral("(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][+-]?\\d+)?");
        static const QRegularExpression number(QStringLiteral("\\G") + digits);
        static const QRegularExpression fraction(
            QStringLiteral("\\G(?<!\\^)(%1)/(%1)").arg(digits));
        static const QRegularExpression word(QStringLiteral("\\G[A-Za-z][A-Za-z0-9_]*"));
        // "1/60 s" is a sixtieth of a second to everybody; "1 / 60 s" is no time.
        if (const auto match = fraction.match(m_text, m_at);
            match.hasMatch() && unitAt(m_text, match.capturedEnd(), m_isValue)) {
            m_at = match.capturedEnd();
            return withUnit(
                {.number = match.captured(1).toDouble() / match.captured(2).toDouble()});
        }
        if (const auto match = number.match(m_text, m_at); match.hasMatch()) {
            m_at = match.capturedEnd();
            return withUnit({.number = match.captured().toDouble()});
        }
        if (const auto match = word.match(m_text, m_at); match.hasMatch()) {
            m_at = match.capturedEnd();
            return named(match.captured());
        }
        return fail(m_at < m_text.size()
                        ? ExpressionText::tr("“%1” is not expected there").arg(m_text.mid(m_at, 12))
                        : ExpressionText::tr("something is missing at its end"));
    }

    /// A number or a parenthesis, with the unit behind it.
    UnitNumber withUnit(const UnitNumber &value)
    {
        const auto unit = unitAt(m_text, m_at, m_isValue);
        if (!unit)
            return value;
        m_at = unit->end;
        if (value.kind == UnitNumber::Kind::Measured)
            return fail(ExpressionText::tr("there is a unit too many"));
        return inUnit(value.number, unit->unit);
    }

    UnitNumber named(const QString &name)
    {
        for (const OfOne &each : ofOne) {
            if (name == QLatin1String(each.name))
                return takes('(') ? applied(each, arguments(1).front()) : noArguments(name);
        }
        for (const OfTwo &each : ofTwo) {
            if (name != QLatin1String(each.name))
                continue;
            if (!takes('('))
                return noArguments(name);
            const std::vector<UnitNumber> two = arguments(2);
            const double number = each.of(two[0].number, two[1].number);
            const UnitNumber both = together(two[0], two[1], number);
            return each.keepsUnit ? both : UnitNumber{.number = number};
        }
        if (name == QLatin1String("pi"))
            return {.number = std::numbers::pi};
        const auto value = m_values.constFind(name);
        return value != m_values.constEnd()
                   ? UnitNumber{*value, UnitNumber::Kind::Any, {}}
                   : fail(ExpressionText::tr("there is no value called %1").arg(name));
    }

    UnitNumber applied(const OfOne &function, const UnitNumber &to)
    {
        const double number = function.of(to.number);
        if (function.unit == UnitOf::Kept)
            return {number, to.kind, to.powers};
        if (to.kind != UnitNumber::Kind::Measured)
            return {number, function.unit == UnitOf::Root ? to.kind : UnitNumber::Kind::Bare, {}};
        if (function.unit == UnitOf::Root)
            return power(to, {.number = 0.5});
        return fail(ExpressionText::tr("%1 is taken of a number without a unit, not of one in %2")
                        .arg(QLatin1String(function.name), nameOf(to.powers)));
    }

    UnitNumber noArguments(const QString &name)
    {
        return fail(ExpressionText::tr("a parenthesis behind %1 is missing").arg(name));
    }

    std::vector<UnitNumber> arguments(int count)
    {
        std::vector<UnitNumber> values;
        for (int i = 0; i < count; ++i) {
            if (i > 0 && !takes(','))
                fail(ExpressionText::tr("a comma and another number are missing"));
            values.push_back(sum());
        }
        if (!takes(')'))
            fail(ExpressionText::tr("a closing parenthesis is missing"));
        return values;
    }

    QString m_text;
    const QMap<QString, double> &m_values;
    std::function<bool(const QString &)> m_isValue = [this](const QString &name) {
        return m_values.contains(name);
    };
    qsizetype m_at = 0;
    int m_depth = 0;
    QString m_fault{};
};

} // namespace

Result<double> evaluated(const QString &text, const QMap<QString, double> &values,
                         const QString &unit)
{
    if (text.size() > longest)
        return Error{
            .message =
                ExpressionText::tr("an expression of at most %1 characters is right").arg(longest)};
    QString plain = text;
    plain.replace(QChar(0x2212), QLatin1Char('-')); // minus sign
    plain.replace(QChar(0x2044), QLatin1Char('/')); // fraction slash
    plain.replace(QChar(0x00B7), QLatin1Char('*')); // middle dot
    const Result<UnitNumber> value = Reader(plain, values).read();
    if (!value)
        return value.error();
    const std::optional<UnitNumber> asked = askedUnit(unit);
    if (!asked || value->kind != UnitNumber::Kind::Measured)
        return value->number;
    if (!value->fits(*asked))
        return noNumber(
            plain,
            ExpressionText::tr("it is in %1; %2 is right here").arg(nameOf(value->powers), unit));
    return value->number / asked->number;
}

bool isValueName(const QString &name)
{
    static const QRegularExpression form(QStringLiteral("^[A-Za-z][A-Za-z0-9_]{0,31}$"));
    if (!form.match(name).hasMatch() || name == QLatin1String("pi"))
        return false;
    for (const OfOne &each : ofOne) {
        if (name == QLatin1String(each.name))
            return false;
    }
    for (const OfTwo &each : ofTwo) {
        if (name == QLatin1String(each.name))
            return false;
    }
    return true;
}

} // namespace cradle
