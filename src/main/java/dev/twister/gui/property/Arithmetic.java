package dev.twister.gui.property;

import java.util.Optional;

/** Numbers as people type them: {@code 1/3}, {@code 2*3}, {@code -(1.5 + 2)} or {@code 0,5}. */
public final class Arithmetic {
    private static final int END = -1;

    private final String text;
    private int at;

    private Arithmetic(String text) {
        this.text = text;
    }

    /** The value; empty if it is no number or not finite. */
    public static Optional<Double> value(String typed) {
        Arithmetic reader = new Arithmetic(typed.replace(',', '.'));
        try {
            double sum = reader.sum();
            return Optional.of(sum).filter(value -> reader.next() == END && Double.isFinite(value));
        } catch (NumberFormatException _) {
            return Optional.empty();
        }
    }

    private double sum() {
        double sum = product();
        for (int sign = next(); sign == '+' || sign == '-'; sign = next()) {
            at++;
            sum += sign == '+' ? product() : -product();
        }
        return sum;
    }

    private double product() {
        double product = factor();
        for (int sign = next(); sign == '*' || sign == '/'; sign = next()) {
            at++;
            product = sign == '*' ? product * factor() : product / factor();
        }
        return product;
    }

    private double factor() {
        int sign = next();
        if (sign == '-' || sign == '+') {
            at++;
            return sign == '-' ? -factor() : factor();
        }
        if (sign != '(') {
            return number();
        }
        at++;
        double inner = sum();
        if (next() != ')') {
            throw new NumberFormatException("no closing parenthesis");
        }
        at++;
        return inner;
    }

    private double number() {
        int start = at;
        while (isOfNumber()) {
            at++;
        }
        return Double.parseDouble(text.substring(start, at));
    }

    private boolean isOfNumber() {
        if (at == text.length()) {
            return false;
        }
        char sign = text.charAt(at);
        boolean exponent = at > 0 && (sign == '-' || sign == '+') && Character.toLowerCase(text.charAt(at - 1)) == 'e';
        return exponent || sign == '.' || Character.toLowerCase(sign) == 'e' || (sign >= '0' && sign <= '9');
    }

    /** The next sign that is not a space. */
    private int next() {
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
        return at < text.length() ? text.charAt(at) : END;
    }
}
