@echo off
rem Starts Twister on Windows: finds a JDK, builds where that is needed, and runs with TornadoVM where its SDK is found.
setlocal EnableExtensions DisableDelayedExpansion

for %%I in ("%~dp0..") do set "TWISTER_HOME=%%~fI"
set "target=%TWISTER_HOME%\target"
set "jar=%target%\twister.jar"
set "stamp=%target%\built-with"
set "sdk_arguments=%target%\tornado-argfile"

set "jdk="
if defined JAVA_HOME call :try_jdk "%JAVA_HOME%"
for /f "delims=" %%I in ('where javac 2^>nul') do call :try_jdk "%%~dpI.."
for /d %%I in ("%ProgramFiles%\Eclipse Adoptium\jdk-*" "%ProgramFiles%\Java\jdk-*" "%ProgramFiles%\Microsoft\jdk-*" "%ProgramFiles%\Zulu\zulu-*" "%ProgramFiles%\GraalVM\*" "%USERPROFILE%\.jdks\*" "%USERPROFILE%\.sdkman\candidates\java\*" "%USERPROFILE%\scoop\apps\*") do call :try_jdk "%%~I"
if not defined jdk (
    echo twister: no JDK 25 or newer was found; install one ^(Temurin, say^) and set JAVA_HOME to its folder 1>&2
    exit /b 2
)

set "sdk="
if defined TORNADOVM_HOME if exist "%TORNADOVM_HOME%\tornado-argfile" set "sdk=%TORNADOVM_HOME%"
if not defined sdk if exist "%USERPROFILE%\.sdkman\candidates\tornadovm\current\tornado-argfile" set "sdk=%USERPROFILE%\.sdkman\candidates\tornadovm\current"

call :is_built
if errorlevel 1 (
    call :build
    if errorlevel 1 exit /b 2
)

if defined sdk (
    set "TORNADOVM_HOME=%sdk%"
    "%jdk%\bin\java" "@%sdk_arguments%" "@%TWISTER_HOME%\scripts\tornado.options" "@%TWISTER_HOME%\scripts\jvm.options" "-XX:CompilerDirectivesFile=%TWISTER_HOME%\scripts\compiler.json" %TWISTER_JAVA_OPTIONS% -cp "%jar%;%target%\lib\*" dev.twister.cli.Main %*
) else (
    "%jdk%\bin\java" "@%TWISTER_HOME%\scripts\jvm.options" "-XX:CompilerDirectivesFile=%TWISTER_HOME%\scripts\compiler.json" %TWISTER_JAVA_OPTIONS% -cp "%jar%;%target%\lib\*" dev.twister.cli.Main %*
)
exit /b %ERRORLEVEL%

:try_jdk
if defined jdk exit /b 0
if not exist "%~1\bin\javac.exe" exit /b 0
if not exist "%~1\release" exit /b 0
set "major=0"
for /f "tokens=2 delims==." %%V in ('findstr /b "JAVA_VERSION=" "%~1\release"') do set "major=%%~V"
rem The release file quotes the whole version, so that its first part begins with a quote.
set "major=%major:"=%"
for /f "tokens=1 delims=-+" %%V in ("%major%") do set "major=%%V"
if %major% geq 25 for %%J in ("%~1") do set "jdk=%%~fJ"
exit /b 0

:is_built
if not exist "%jar%" exit /b 1
if not exist "%stamp%" exit /b 1
if defined sdk if not exist "%sdk_arguments%" exit /b 1
set "built_with="
set /p built_with=<"%stamp%"
if not "%built_with%"=="sdk [%sdk%] jdk [%jdk%]" exit /b 1
powershell -NoProfile -Command "$built = (Get-Item -LiteralPath $env:stamp).LastWriteTime; Set-Location -LiteralPath $env:TWISTER_HOME; $newer = Get-Item pom.xml, src/main; $newer += Get-ChildItem -Recurse src/main, src/tornado/java, .mvn -ErrorAction SilentlyContinue; if ($newer | Where-Object { $_.LastWriteTime -gt $built }) { exit 1 }"
exit /b %ERRORLEVEL%

:build
echo building Twister... 1>&2
rem The TornadoVM engine's classes must not stay where there is no SDK any more.
if exist "%target%\classes" rmdir /s /q "%target%\classes"
if exist "%target%\maven-status" rmdir /s /q "%target%\maven-status"
if not exist "%target%" mkdir "%target%"
if not defined sdk goto prepared
rem The SDK's own argument file has the current folder on its module path: a stray jar there would stop the JVM.
powershell -NoProfile -Command "(Get-Content -LiteralPath (Join-Path $env:sdk 'tornado-argfile')) -replace '^(--module-path[ =]\x22?)\.;', '$1' | Set-Content -Encoding ascii -LiteralPath $env:sdk_arguments"
"%jdk%\bin\java" "@%sdk_arguments%" "@%TWISTER_HOME%\scripts\tornado.options" -version >nul 2>&1
if errorlevel 1 (
    del "%sdk_arguments%"
    echo twister: the TornadoVM SDK in %sdk% does not run on the JDK in %jdk%. Set JAVA_HOME to the JDK that the SDK is made for, or install an SDK made for this one 1>&2
    exit /b 1
)
:prepared
rem The sources' state is that of now, whatever is edited while the build runs.
>"%stamp%.new" echo sdk [%sdk%] jdk [%jdk%]
pushd "%TWISTER_HOME%"
set "JAVA_HOME=%jdk%"
set "TORNADOVM_HOME=%sdk%"
call mvnw.cmd -q -DskipTests package 1>&2
if errorlevel 1 (
    popd
    echo twister: the build failed; its messages are above 1>&2
    exit /b 1
)
popd
move /y "%stamp%.new" "%stamp%" >nul
exit /b 0
