package dev.twister.engine.tornado;

import uk.ac.manchester.tornado.api.exceptions.TornadoDeviceFP64NotSupported;
import uk.ac.manchester.tornado.api.exceptions.TornadoMemoryException;
import uk.ac.manchester.tornado.api.exceptions.TornadoOutOfMemoryException;

/** Says what went wrong on a device, and what to do about it. TornadoVM throws whatever its parts threw. */
final class DeviceFailure {
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
                + " -Dtornado.device.memory=8GB (" + reason(failure) + ")";
    }

    /** The first message on the way to the root, and the kind of the exception where its message says little. */
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
        return message == null || message.isBlank()
                ? failure.getClass().getSimpleName()
                : message.strip().replaceAll("\\s*\\R\\s*", " ");
    }
}
