package dev.twister.denoise;

import java.io.EOFException;
import java.io.IOException;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.concurrent.CompletableFuture;

/**
 * The process in which Open Image Denoise runs, because a library that crashes ends the process that loads it. It
 * answers over a socket: what the library itself prints may be endless.
 *
 * <p>It answers with {@link #WORKS} and the library's version, then reads one {@link Request} after the other, each
 * with its planes, and answers with {@link #WORKS} and the values of the rows that are asked for. If something fails,
 * it answers with {@link #REFUSED} and why, and ends.
 */
final class OidnServer {
    static final int WORKS = 1;
    static final int REFUSED = 0;
    private static final int SIDE = 16;
    private static final int BYTES_A_PIXEL = 3 * Float.BYTES;

    private OidnServer() {}

    /**
     * What is asked.
     *
     * @param rows number of rows of each plane
     * @param first the first row that is answered
     * @param end the row after the last one that is answered
     * @param guided whether albedo and normal follow the radiance
     * @param scale {@link InputScale}
     */
    record Request(int width, int rows, int first, int end, boolean guided, float scale) {
        void write(FloatChannel channel) throws IOException {
            channel.writeInts(width, rows, first, end, guided ? 1 : 0, Float.floatToRawIntBits(scale));
        }

        private static Request read(FloatChannel channel) throws IOException {
            return new Request(
                    channel.readInt(),
                    channel.readInt(),
                    channel.readInt(),
                    channel.readInt(),
                    channel.readInt() == 1,
                    Float.intBitsToFloat(channel.readInt()));
        }
    }

    /**
     * Serves until nobody asks any more.
     *
     * @param arguments the library's file or name, and the path of the socket
     */
    public static void main(String[] arguments) throws IOException {
        ProcessHandle.current().parent().ifPresent(OidnServer::endWith);
        try (FloatChannel channel = new FloatChannel(SocketChannel.open(UnixDomainSocketAddress.of(arguments[1])))) {
            serve(arguments[0], channel);
        } catch (EOFException _) {
            // Nobody asks any more.
        }
        // The library's threads may go on.
        Runtime.getRuntime().halt(0);
    }

    private static void endWith(ProcessHandle parent) {
        CompletableFuture<Void> _ =
                parent.onExit().thenRun(() -> Runtime.getRuntime().halt(1));
    }

    private static void serve(String place, FloatChannel channel) throws IOException {
        try (OidnFilters filters = new OidnFilters(place)) {
            try (OidnFilters.Images black = filters.images(SIDE, SIDE, false)) {
                filters.denoise(black, 1);
            }
            channel.writeInts(WORKS);
            channel.writeText(filters.text());
            for (; ; ) {
                answer(filters, channel);
            }
        } catch (DenoiseException problem) {
            channel.writeInts(REFUSED);
            channel.writeText(problem.getMessage());
        }
    }

    private static void answer(OidnFilters filters, FloatChannel channel) throws IOException {
        Request request = Request.read(channel);
        try (OidnFilters.Images images = filters.images(request.width(), request.rows(), request.guided())) {
            for (ByteBuffer plane : images.inputs()) {
                channel.read(plane);
            }
            filters.denoise(images, request.scale());
            int row = BYTES_A_PIXEL * request.width();
            channel.writeInts(WORKS);
            channel.write(images.output().position(row * request.first()).limit(row * request.end()));
        }
    }
}
