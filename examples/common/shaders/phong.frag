out vec4 colour;

void main()
{
    colour = surface();
}
