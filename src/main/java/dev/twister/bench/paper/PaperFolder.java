package dev.twister.bench.paper;

import dev.twister.bench.benchmark.BenchmarkReport;
import dev.twister.bench.benchmark.Setting;
import dev.twister.bench.figures.RenderedFigure;
import dev.twister.files.SystemReason;
import dev.twister.files.WholeFile;
import dev.twister.image.Frame;
import dev.twister.image.PngWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Writes the paper's evaluation to a folder: pictures, plots, and a page that shows everything. */
public final class PaperFolder {
    /** File name of the page. */
    public static final String PAGE = "index.html";

    /** File name of the report. */
    public static final String JSON = "paper.json";

    /** File name of the report for spreadsheets. */
    public static final String CSV = "paper.csv";

    private static final String PLOT_ENDING = ".svg";

    private PaperFolder() {}

    /**
     * Creates the folder and its parents, if necessary.
     *
     * @throws IOException naming the folder and why it cannot be created
     */
    public static void make(Path folder) throws IOException {
        try {
            Files.createDirectories(folder);
        } catch (NoSuchFileException refused) {
            throw new IOException("cannot make the folder " + folder + ": none can be made there", refused);
        } catch (IOException problem) {
            throw new IOException("cannot make the folder " + folder + ": " + SystemReason.of(problem), problem);
        }
    }

    /**
     * Writes the pictures, plots and the page; on failure each file is complete or unchanged. Plots of an earlier
     * evaluation that this one lacks are deleted.
     *
     * @param folder must exist
     * @param srgb whether the pictures are sRGB-encoded
     * @param figures the paper's rendered figures, for the page
     * @return the page
     * @throws IOException as for {@link WholeFile#write}, or if the system has no fonts for plots
     */
    public static Path write(BenchmarkReport report, Path folder, boolean srgb, List<RenderedFigure> figures)
            throws IOException {
        Map<Setting, byte[]> pictures = new HashMap<>();
        for (Map.Entry<Setting, Frame> picture : report.pictures().entrySet()) {
            Setting setting = picture.getKey();
            Frame frame = picture.getValue();
            Path file = folder.resolve(
                    "picture-" + setting.shadowSamples() + "-samples-" + setting.bounces() + "-bounces.png");
            PngWriter.write(file, frame.width(), frame.height(), frame.argb(), srgb);
            pictures.put(setting, Files.readAllBytes(file));
        }
        Map<String, String> plots = plots(report, folder);
        for (String name : PaperPlots.names()) {
            if (!plots.containsKey(name)) {
                // A plot of an earlier evaluation would be mistaken for one of this evaluation.
                Files.deleteIfExists(folder.resolve(name + PLOT_ENDING));
            }
        }
        for (Map.Entry<String, String> plot : plots.entrySet()) {
            writeText(folder.resolve(plot.getKey() + PLOT_ENDING), plot.getValue());
        }
        Path page = folder.resolve(PAGE);
        writeText(page, PaperPage.of(report, plots, pictures, figures));
        return page;
    }

    private static Map<String, String> plots(BenchmarkReport report, Path folder) throws IOException {
        try {
            return PaperPlots.of(report);
        } catch (InternalError | UnsatisfiedLinkError noFonts) {
            throw new IOException(
                    "the plots cannot be drawn, because Java finds no fonts here (" + noFonts.getMessage()
                            + "); install some (apt install fontconfig fonts-dejavu-core). The numbers are in "
                            + folder,
                    noFonts);
        }
    }

    private static void writeText(Path file, String text) throws IOException {
        WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
