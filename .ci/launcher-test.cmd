@echo off
rem This file is UTF-8.
chcp 65001 >nul
rem Tries the launcher where Windows' launchers break: parentheses, ampersands and letters in names.
setlocal EnableExtensions DisableDelayedExpansion
for %%I in ("%~dp0..") do set "home=%%~fI"
set "folder=%TEMP%\twister-test"
if exist "%folder%" rmdir /s /q "%folder%"
mkdir "%folder%"
cd /d "%folder%"

echo launcher: names may hold what ends or parts commands
rem A copy of what is built, with its times.
set "copy=%folder%\a (b) & c! höhe"
robocopy "%home%" "%copy%" /e /dcopy:DAT /xd .git /nfl /ndl /njh /njs >nul
call "%copy%\scripts\twister.cmd" render teaching -o "picture (1) & more.png" --size 32x18 2>err
if errorlevel 1 goto failed
if not exist "picture (1) & more.png" goto failed
findstr /b /c:"building" err >nul && goto failed

echo launcher: exit codes come through, and messages are whole
call "%copy%\scripts\twister.cmd" render "no (such) & scene.json" -o x.png 2>err
if not "%ERRORLEVEL%"=="2" goto failed
findstr /c:"no (such) & scene.json" err >nul || goto failed

echo launcher: the JVM says why it does not start, and the user's collector wins
set "JAVA_TOOL_OPTIONS=-XX:+UseG1GC"
call "%copy%\scripts\twister.cmd" --version >out 2>err
if errorlevel 1 goto failed
set "JAVA_TOOL_OPTIONS=-Xmx1m"
call "%copy%\scripts\twister.cmd" --version >out 2>err
if not "%ERRORLEVEL%"=="1" goto failed
findstr /c:"heap" err >nul || goto failed
set "JAVA_TOOL_OPTIONS="

echo launcher: an SDK that does not work is told of, wherever it is
set "TORNADOVM_HOME=%folder%\sdk (1) & ü"
mkdir "%TORNADOVM_HOME%"
>"%TORNADOVM_HOME%\tornado-argfile" echo -XX:+NoSuchOption
call "%copy%\scripts\twister.cmd" --version >out 2>err
if not "%ERRORLEVEL%"=="2" goto failed
findstr /c:"does not run on the JDK in" err >nul || goto failed
set "TORNADOVM_HOME="

echo launcher: without a JDK there is one line and exit code 2
set "JAVA_HOME="
set "PATH=%SystemRoot%\System32"
set "ProgramFiles=%folder%"
set "USERPROFILE=%folder%"
call "%copy%\scripts\twister.cmd" --version >out 2>err
if not "%ERRORLEVEL%"=="2" goto failed
findstr /c:"no JDK 25 or newer was found" err >nul || goto failed

cd /d "%home%"
rmdir /s /q "%folder%"
echo launcher: all is well
exit /b 0

:failed
echo launcher: failed 1>&2
type err 1>&2
exit /b 1
