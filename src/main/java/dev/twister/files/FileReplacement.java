package dev.twister.files;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Path;

/**
 * A new version of a file, written to a temporary file in the same folder. It takes the file's name only when
 * {@link #finish} is called; closed before that, or if the process ends, it is deleted and the earlier version stays.
 */
public final class FileReplacement implements AutoCloseable {
    private static final int BUFFER_BYTES = 1 << 16;

    private final TemporaryFile temporary;
    private final FileChannel channel;
    private final OutputStream out;

    private FileReplacement(TemporaryFile temporary, FileChannel channel) {
        this.temporary = temporary;
        this.channel = channel;
        out = new BufferedOutputStream(Channels.newOutputStream(channel), BUFFER_BYTES);
    }

    /**
     * Creates the temporary file.
     *
     * @param target no folder or device; if it is a link, what it leads to is replaced
     * @throws IOException as the system reports it, see {@link WholeFile#explained}
     */
    public static FileReplacement of(Path target) throws IOException {
        TemporaryFile temporary = TemporaryFile.of(WholeFile.behindLinks(target));
        try {
            return new FileReplacement(temporary, temporary.create());
        } catch (IOException | RuntimeException failure) {
            temporary.close();
            throw failure;
        }
    }

    /** Receives the content; buffered. */
    public OutputStream out() {
        return out;
    }

    /** The temporary file. */
    public Path path() {
        return temporary.path();
    }

    /** Lets another program write the temporary file. */
    public void share() throws IOException {
        temporary.share();
    }

    /** Reads the content back. */
    public FileChannel channel() {
        return channel;
    }

    /** Waits until the content is on the disk, and gives it the target's name. */
    public void finish() throws IOException {
        out.flush();
        // Otherwise a power failure soon after could leave an empty file under the new name.
        channel.force(true);
        channel.close();
        temporary.moveIntoPlace();
    }

    @Override
    public void close() throws IOException {
        try (temporary;
                channel) {
            // Closed in this order: the channel, then the file.
        }
    }
}
