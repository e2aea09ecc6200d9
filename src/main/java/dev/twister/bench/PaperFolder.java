package dev.twister.bench;

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

/** Writes the paper's evaluation into a folder: the pictures, the plots, and the page that shows everything. */
public final class PaperFolder {
    /** The page that shows everything. */
    public static final String PAGE = "index.html";

    /** The report, which is written beside the page. */
    public static final String JSON = "paper.json";

    /** The same for spreadsheets. */
    public static final String CSV = "paper.csv";

    private static final String PLOT_ENDING = ".svg";

    private PaperFolder() {}

    /**
     * Makes the folder, and those that it is in, where they are not there.
     *
     * @throws IOException naming the folder, and why it cannot be made
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
     * Writes the pictures, the plots and the page, each file whole or not at all. An older evaluation's plots of what
     * was not measured now are gone then.
     *
     * @param folder must be there
     * @param srgb whether the pictures are sRGB-encoded
     * @param figures the paper's rendered figures, for the page
     * @return the page
     * @throws IOException as {@link WholeFile#write}, or where this system has no fonts to draw plots with
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
                // An older evaluation's would be taken for this one's.
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
