package dev.twister.bench.paper;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import org.knowm.xchart.style.AxesChartStyler;
import org.knowm.xchart.style.Styler.LegendLayout;
import org.knowm.xchart.style.Styler.LegendPosition;

/** The common style of all plots. */
final class PlotLook {
    static final int WIDTH = 960;
    static final int HEIGHT = 480;

    /**
     * Ratio of the largest to the smallest value from which the axis is logarithmic, because a linear one hides small
     * values.
     */
    private static final double LOGARITHMIC_FROM = 10;

    private static final int DIGITS = 3;
    private static final int TITLE_POINTS = 18;
    private static final int TEXT_POINTS = 14;
    private static final int LABEL_POINTS = 13;
    private static final int TICK_GAP = 6;
    private static final int LEGEND_GAP = 16;

    /** Factor for the axis's maximum, which leaves room for the largest value's label. */
    private static final double HEADROOM = 1.1;

    /** Paul Tol's bright colors, which people with color vision deficiency can distinguish. */
    private static final List<Color> COLORS = List.of(
            new Color(0x4477AA),
            new Color(0xEE6677),
            new Color(0x228833),
            new Color(0xCCBB44),
            new Color(0x66CCEE),
            new Color(0xAA3377));

    private static final Color PUBLISHED = new Color(0xBBBBBB);
    private static final Color GRID = new Color(0xE4E4E8);
    private static final Color INK = new Color(0x22, 0x26, 0x2E);

    private PlotLook() {}

    /** The color of the engine with that index in the plan, the same in all plots. */
    static Color color(int engine) {
        return COLORS.get(engine % COLORS.size());
    }

    /** The color of the paper's own figures. */
    static Color published() {
        return PUBLISHED;
    }

    static Font labelFont() {
        return new Font(Font.SANS_SERIF, Font.PLAIN, LABEL_POINTS);
    }

    static void apply(AxesChartStyler styler) {
        styler.setAxisTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, TEXT_POINTS))
                .setAxisTickLabelsFont(new Font(Font.SANS_SERIF, Font.PLAIN, TEXT_POINTS))
                .setAxisTickLabelsColor(INK)
                .setPlotGridLinesColor(GRID)
                .setPlotGridLinesStroke(new BasicStroke(1))
                .setPlotGridVerticalLinesVisible(false)
                .setAxisTickPadding(TICK_GAP)
                .setPlotMargin(0);
        styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, TITLE_POINTS))
                .setLegendFont(new Font(Font.SANS_SERIF, Font.PLAIN, TEXT_POINTS))
                .setChartFontColor(INK)
                .setChartBackgroundColor(Color.WHITE)
                .setPlotBackgroundColor(Color.WHITE)
                .setPlotBorderVisible(false)
                .setLegendBorderColor(Color.WHITE)
                .setLegendPosition(LegendPosition.OutsideS)
                .setLegendLayout(LegendLayout.Horizontal)
                .setLegendPadding(LEGEND_GAP)
                .setChartPadding(TEXT_POINTS);
        styler.setYAxisTickLabelsFormattingFunction(PlotLook::number);
    }

    /** Sets the vertical axis for positive values. */
    static void scale(AxesChartStyler styler, List<Double> values) {
        double least = values.stream().mapToDouble(Double::doubleValue).min().orElse(1);
        double most = values.stream().mapToDouble(Double::doubleValue).max().orElse(1);
        if (most / least >= LOGARITHMIC_FROM) {
            styler.setYAxisLogarithmic(true)
                    .setYAxisLogarithmicDecadeOnly(true)
                    // Keeps a bar of the smallest value visible.
                    .setYAxisMin(Math.pow(10, Math.floor(Math.log10(least * 0.8))))
                    .setYAxisMax(Math.pow(10, Math.ceil(Math.log10(most * HEADROOM))));
        } else {
            styler.setYAxisMin(0.0).setYAxisMax(most * HEADROOM);
        }
    }

    /** Three significant digits, without an exponent. */
    static String number(double value) {
        if (Math.abs(value) >= Math.pow(10, DIGITS)) {
            return String.valueOf(Math.round(value));
        }
        BigDecimal rounded = BigDecimal.valueOf(value).round(new MathContext(DIGITS, RoundingMode.HALF_UP));
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }
}
