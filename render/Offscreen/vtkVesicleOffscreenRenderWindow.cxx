#include "vtkVesicleOffscreenRenderWindow.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)

#include "OffscreenContext.h"

#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtk_glew.h"

namespace
{

/// VTK's own default for a window whose size nobody set.
constexpr int defaultSide = 300;

/// glewInit's answer where there is no X display (GLEW_ERROR_NO_GLX_DISPLAY, unknown to older
/// headers): by then every OpenGL function is loaded; only GLX's own are missing.
constexpr GLenum glewErrorNoGlxDisplay = 4;

}

vtkVesicleOffscreenRenderWindow::vtkVesicleOffscreenRenderWindow()
{
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->FrameBlitMode = NoBlit;
  this->DoubleBuffer = 0;
}

vtkVesicleOffscreenRenderWindow::~vtkVesicleOffscreenRenderWindow()
{
  this->Finalize();
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

void vtkVesicleOffscreenRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << this->Context.get() << "\n";
}

void vtkVesicleOffscreenRenderWindow::Initialize()
{
  if (!this->Context)
  {
    this->CreateAWindow();
  }
}

void vtkVesicleOffscreenRenderWindow::Finalize()
{
  if (this->Context)
  {
    this->DestroyWindow();
  }
}

void vtkVesicleOffscreenRenderWindow::CreateAWindow()
{
  std::string whyNot;
  this->Context = this->CreateContext(whyNot);
  if (!this->Context)
  {
    vtkErrorMacro("no OpenGL context: " << whyNot);
    return;
  }
  for (int& side : this->Size)
  {
    side = side > 0 ? side : defaultSide;
  }
  this->Mapped = 0;
  this->MakeCurrent();
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
  {
    // Whatever they hold belongs to an earlier context.
    renderer->SetRenderWindow(nullptr);
    renderer->SetRenderWindow(this);
  }
  this->OpenGLInit();
}

void vtkVesicleOffscreenRenderWindow::DestroyWindow()
{
  this->MakeCurrent();
  this->ReleaseGraphicsResources(this);
  delete[] this->Capabilities;
  this->Capabilities = nullptr;
  this->Initialized = false;
  this->Mapped = 0;
  this->Context.reset();
}

void vtkVesicleOffscreenRenderWindow::Frame()
{
  this->MakeCurrent();
  this->Superclass::Frame();
}

void vtkVesicleOffscreenRenderWindow::MakeCurrent()
{
  if (this->Context && !this->Context->make_current())
  {
    vtkErrorMacro("another window system's OpenGL context is current on this thread; "
                  "draw off-screen on a thread of its own");
  }
}

bool vtkVesicleOffscreenRenderWindow::IsCurrent()
{
  return this->Context && this->Context->is_current();
}

void vtkVesicleOffscreenRenderWindow::ReleaseCurrent()
{
  if (this->Context)
  {
    this->Context->release_current();
  }
}

void vtkVesicleOffscreenRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == glewErrorNoGlxDisplay;
  if (!this->GlewInitValid || !GLEW_VERSION_3_2)
  {
    vtkErrorMacro("this context has no OpenGL 3.2");
    return;
  }
  this->Initialized = true;
  float range[2] = { 1, 1 };
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

int* vtkVesicleOffscreenRenderWindow::GetScreenSize()
{
  this->ScreenSize[0] = this->Size[0];
  this->ScreenSize[1] = this->Size[1];
  return this->ScreenSize;
}

void* vtkVesicleOffscreenRenderWindow::GetGenericContext()
{
  return this->Context.get();
}

#endif
