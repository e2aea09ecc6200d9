package dev.twister.bench.paper;

import java.awt.Dimension;
import java.io.StringWriter;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.knowm.xchart.internal.chartpart.Chart;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/** Renders a plot as an SVG document. */
final class SvgPlot {
    private static final String NAMESPACE = "http://www.w3.org/2000/svg";

    private SvgPlot() {}

    /** The document's text. Letters are converted to shapes, so that it looks the same with other fonts. */
    static String of(Chart<?, ?> chart, String description) {
        try {
            Document document = DocumentBuilderFactory.newDefaultNSInstance()
                    .newDocumentBuilder()
                    .getDOMImplementation()
                    .createDocument(NAMESPACE, "svg", null);
            SVGGeneratorContext context = SVGGeneratorContext.createDefault(document);
            context.setComment(null);
            SVGGraphics2D graphics = new SVGGraphics2D(context, true);
            graphics.setSVGCanvasSize(new Dimension(PlotLook.WIDTH, PlotLook.HEIGHT));
            chart.paint(graphics, PlotLook.WIDTH, PlotLook.HEIGHT);
            Element root = graphics.getRoot();
            root.setAttribute("viewBox", "0 0 " + PlotLook.WIDTH + " " + PlotLook.HEIGHT);
            root.setAttribute("role", "img");
            root.setAttribute("aria-label", description);
            StringWriter text = new StringWriter();
            graphics.stream(root, text, true, false);
            // Omits Batik's header, which refers to a document type definition on the network.
            String whole = text.toString();
            return whole.substring(whole.indexOf("<svg"));
        } catch (ParserConfigurationException | SVGGraphics2DIOException impossible) {
            throw new IllegalStateException("the plot cannot be written into memory", impossible);
        }
    }
}
