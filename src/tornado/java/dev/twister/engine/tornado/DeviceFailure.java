package dev.twister.engine.tornado;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uk.ac.manchester.tornado.api.exceptions.TornadoDeviceFP64NotSupported;
import uk.ac.manchester.tornado.api.exceptions.TornadoMemoryException;
import uk.ac.manchester.tornado.api.exceptions.TornadoOutOfMemoryException;

/** Error messages for failures on devices. TornadoVM passes on whatever its parts throw. */
final class DeviceFailure {
    /** Terminal colors in TornadoVM's messages. */
    private static final Pattern COLOR = Pattern.compile("\\u001B\\[[;\\d]*m");

    /** The stack trace that TornadoVM appends to its messages, about a thousand characters. */
    private static final Pattern TRACE = Pattern.compile("\\s*Stacktrace: \\[.*", Pattern.DOTALL);

    private static final String MEMORY = "tornado.device.memory";
    private static final Pattern GIGABYTES = Pattern.compile("(\\d{1,9})GB");
    private static final long LEAST_GIGABYTES = 8;

    private static final Pattern LINE_BREAK = Pattern.compile("\\s*\\R\\s*");

    private DeviceFailure() {}

    static String message(String device, Throwable failure) {
        return switch (failure) {
            case TornadoOutOfMemoryException e -> memory(device, e);
            case TornadoMemoryException e -> memory(device, e);
            case TornadoDeviceFP64NotSupported e ->
                "TornadoVM made a kernel with doubles, which " + device + " does not have: " + reason(e);
            default -> "TornadoVM could not compile or run the kernel on " + device + ": " + reason(failure);
        };
    }

    private static String memory(String device, Throwable failure) {
        return device + " has too little memory for this picture: draw a smaller one, or give TornadoVM more with"
                + " -D" + MEMORY + "=" + moreGigabytes(System.getProperty(MEMORY, "")) + "GB (" + reason(failure) + ")";
    }

    /** Twice what is set, at least 8. */
    static long moreGigabytes(String set) {
        Matcher gigabytes = GIGABYTES.matcher(set);
        return gigabytes.matches()
                ? Math.max(LEAST_GIGABYTES, 2 * Long.parseLong(gigabytes.group(1)))
                : LEAST_GIGABYTES;
    }

    /** The failure's message and that of its cause; the exception's class where a message is empty. */
    private static String reason(Throwable failure) {
        StringBuilder reason = new StringBuilder(said(failure));
        Throwable cause = failure.getCause();
        if (cause != null) {
            reason.append("; ").append(said(cause));
        }
        return reason.toString();
    }

    private static String said(Throwable failure) {
        String message = failure.getMessage();
        String plain = message == null ? "" : COLOR.matcher(message).replaceAll("");
        String reason = TRACE.matcher(plain).replaceFirst("").strip();
        return reason.isEmpty()
                ? failure.getClass().getSimpleName()
                : LINE_BREAK.matcher(reason).replaceAll(" ");
    }
}
