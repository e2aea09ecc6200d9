package dev.twister.bench;

import dev.twister.files.SystemReason;
import dev.twister.files.WholeFile;
import dev.twister.image.PngWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** Writes the evaluation into a folder: the numbers, the pictures, the plots, and the page that shows them all. */
public final class PaperFolder {
    /** The page that shows everything. */
    public static final String PAGE = "index.html";

    /** The numbers of an evaluation that goes on, or was stopped. */
    public static final String UNFINISHED_JSON = "paper-unfinished.json";

    /** The same for spreadsheets. */
    public static final String UNFINISHED_CSV = "paper-unfinished.csv";

    private static final String JSON = "paper.json";
    private static final String CSV = "paper.csv";
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
     * Writes all files, each whole or not at all; the numbers first, so that they are there whatever fails later. Unfinished
     * numbers, and an older evaluation's plots of what was not measured now, are gone then.
     *
     * @param folder must be there
     * @return the page
     * @throws IOException as {@link WholeFile#write}, or where this system has no fonts to draw plots with
     */
    public static Path write(PaperReport report, Path folder) throws IOException {
        PaperJson.write(report, folder.resolve(JSON));
        PaperCsv.write(report, folder.resolve(CSV));
        Files.deleteIfExists(folder.resolve(UNFINISHED_JSON));
        Files.deleteIfExists(folder.resolve(UNFINISHED_CSV));
        Map<PaperPicture, byte[]> pictures = new LinkedHashMap<>();
        for (PaperPicture picture : report.pictures()) {
            Path file = folder.resolve(picture.fileName());
            PngWriter.write(
                    file,
                    picture.frame().width(),
                    picture.frame().height(),
                    picture.frame().argb());
            pictures.put(picture, Files.readAllBytes(file));
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
        writeText(page, PaperPage.of(report, plots, pictures));
        return page;
    }

    /**
     * Writes the numbers that there are so far, each file whole or not at all, and leaves those of a finished evaluation alone.
     *
     * @param folder must be there
     * @throws IOException as {@link WholeFile#write}
     */
    public static void writeUnfinished(PaperReport report, Path folder) throws IOException {
        PaperJson.write(report, folder.resolve(UNFINISHED_JSON));
        PaperCsv.write(report, folder.resolve(UNFINISHED_CSV));
    }

    private static Map<String, String> plots(PaperReport report, Path folder) throws IOException {
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
